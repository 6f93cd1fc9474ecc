// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/highlights_over.hpp>

#include <arcspan_tools/render/render.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace arcspan::tools {

/// The scalars of up to four lights: N·L of light i is number i, and 4 + i is its N·H (Blinn) or N·V (Phong,
/// the same for all). Those of lights that are not there are zero.
inline constexpr std::size_t kAnyLights = 4;
using AnyScalars = std::array<Cosine, 2 * kAnyLights>;

/// An Illumination whose type is known at run time only: the one that a firmware with these lights has.
class IlluminationCalls {
 public:
  virtual ~IlluminationCalls() = default;

  [[nodiscard]] virtual bool has_ramp() const = 0;
  [[nodiscard]] virtual AnyScalars scalars(const Direction& normal) const = 0;
  [[nodiscard]] virtual PackedRgb colour(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual DeepColour deep_colour(const AnyScalars& scalars) const = 0;
  /// The next four are for an illumination that has a ramp.
  [[nodiscard]] virtual Cosine diffuse_scalar(const AnyScalars& scalars, std::uint32_t lit) const = 0;
  [[nodiscard]] virtual Cosine diffuse_sum(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual PackedRgb diffuse_colour(Cosine normal_light) const = 0;
  [[nodiscard]] virtual LinearLevel linear_level() const = 0;

  // The functions that `Arc` calls.
  [[nodiscard]] virtual Status set_tolerance(std::int32_t steps) = 0;
  [[nodiscard]] virtual bool is_dark(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c) const = 0;
  [[nodiscard]] virtual TriangleLight light_over(const AnyScalars& a, const AnyScalars& b,
                                                 const AnyScalars& c, std::uint32_t widest) const = 0;
  [[nodiscard]] virtual Cosine pixel_scalar(Cosine scalar, std::size_t i) const = 0;
  [[nodiscard]] virtual PackedRgb surface_colour(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual PixelLight surface_light(const AnyScalars& scalars) const = 0;
  /// For an illumination without a ramp.
  [[nodiscard]] virtual ChannelLight channel_light(const AnyScalars& scalars) const = 0;
  /// The highlight on a texture, as a wide_spread(), for one with a ramp.
  [[nodiscard]] virtual std::uint32_t shine(const AnyScalars& scalars) const = 0;

  // The further functions that `Segment` calls.
  [[nodiscard]] virtual bool lit_throughout(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                            std::uint32_t& lit) const = 0;
  [[nodiscard]] virtual bool may_shine(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                       Cosine headroom) const = 0;
  [[nodiscard]] virtual HighlightBound highlights_over(const AnyScalars& a, const AnyScalars& b,
                                                       const AnyScalars& c, std::uint32_t ab,
                                                       std::uint32_t ac, std::uint32_t bc) const = 0;
  [[nodiscard]] virtual std::uint32_t widest_patch() const = 0;
  [[nodiscard]] virtual const PowerTable& power() const = 0;
};

/// The illumination by 1 to 4 lights that firmware uses: with a ramp unless one of several lights is
/// coloured. Throws Failure for other numbers of lights, and for materials and lights that
/// Illumination::make() rejects, and for a toon by coloured lights.
[[nodiscard]] std::unique_ptr<IlluminationCalls> make_any_illumination(const Material& material,
                                                                       const RenderJob& job);

/// IlluminationCalls with the interface of an Illumination of four lights, so that one instantiation of a
/// method for every number of lights and both models draws the pixels that firmware draws. Flat, Gouraud and
/// the methods of the literature except Segment do not ask for a ramp, so that one of the two types serves
/// them.
template <bool HasRamp>
class AnyIllumination {
 public:
  static constexpr std::size_t kLights = kAnyLights;
  static constexpr std::size_t kScalars = 2 * kAnyLights;
  static constexpr bool kHasRamp = HasRamp;
  using Scalars = AnyScalars;

  /// `calls` must live as long as this.
  explicit AnyIllumination(IlluminationCalls& calls) : calls_(&calls) {}

  [[nodiscard]] Scalars scalars(const Direction& normal) const { return calls_->scalars(normal); }
  [[nodiscard]] PackedRgb colour(const Scalars& scalars) const { return calls_->colour(scalars); }
  [[nodiscard]] DeepColour deep_colour(const Scalars& scalars) const { return calls_->deep_colour(scalars); }
  [[nodiscard]] Cosine diffuse_scalar(const Scalars& scalars, std::uint32_t lit) const requires HasRamp {
    return calls_->diffuse_scalar(scalars, lit);
  }
  template <std::size_t Count>
  [[nodiscard]] Cosine diffuse_sum(const std::array<Cosine, Count>& scalars) const
      requires(HasRamp&& Count >= kAnyLights) {
    AnyScalars all{};
    std::copy_n(scalars.begin(), kAnyLights, all.begin());
    return calls_->diffuse_sum(all);
  }
  [[nodiscard]] PackedRgb diffuse_colour(Cosine normal_light) const requires HasRamp {
    return calls_->diffuse_colour(normal_light);
  }
  [[nodiscard]] LinearLevel linear_level() const requires HasRamp { return calls_->linear_level(); }

  /// Sets the tolerance of all copies.
  [[nodiscard]] Status set_tolerance(std::int32_t steps) { return calls_->set_tolerance(steps); }
  [[nodiscard]] bool is_dark(const Scalars& a, const Scalars& b, const Scalars& c) const {
    return calls_->is_dark(a, b, c);
  }
  [[nodiscard]] TriangleLight light_over(const Scalars& a, const Scalars& b, const Scalars& c,
                                         std::uint32_t widest) const {
    return calls_->light_over(a, b, c, widest);
  }
  [[nodiscard]] Cosine pixel_scalar(Cosine scalar, std::size_t i) const {
    return calls_->pixel_scalar(scalar, i);
  }
  [[nodiscard]] PackedRgb surface_colour(const Scalars& scalars) const {
    return calls_->surface_colour(scalars);
  }
  [[nodiscard]] PixelLight surface_light(const Scalars& scalars) const {
    return calls_->surface_light(scalars);
  }
  [[nodiscard]] ChannelLight channel_light(const Scalars& scalars) const requires(!HasRamp) {
    return calls_->channel_light(scalars);
  }
  /// LightTables::shine_at().
  [[nodiscard]] std::uint32_t shine_at(const AnyIllumination&,
                                       const Scalars& scalars) const requires HasRamp {
    return calls_->shine(scalars);
  }

  [[nodiscard]] bool lit_throughout(const Scalars& a, const Scalars& b, const Scalars& c,
                                    std::uint32_t& lit) const {
    return calls_->lit_throughout(a, b, c, lit);
  }
  [[nodiscard]] friend bool may_shine(const AnyIllumination& lit, const Scalars& a, const Scalars& b,
                                      const Scalars& c, Cosine headroom) {
    return lit.calls_->may_shine(a, b, c, headroom);
  }
  [[nodiscard]] friend HighlightBound highlights_over(const AnyIllumination& lit, const Scalars& a,
                                                      const Scalars& b, const Scalars& c, std::uint32_t ab,
                                                      std::uint32_t ac, std::uint32_t bc) {
    return lit.calls_->highlights_over(a, b, c, ab, ac, bc);
  }
  [[nodiscard]] std::uint32_t widest_patch() const { return calls_->widest_patch(); }
  [[nodiscard]] const PowerTable& power() const { return calls_->power(); }

 private:
  IlluminationCalls* calls_;
};

}  // namespace arcspan::tools
