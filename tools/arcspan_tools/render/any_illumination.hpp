// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

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
  [[nodiscard]] virtual std::size_t lights() const = 0;
  [[nodiscard]] virtual Highlight model() const = 0;
  [[nodiscard]] virtual AnyScalars scalars(const Direction& normal) const = 0;
  [[nodiscard]] virtual PackedRgb colour(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual PixelLight light(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual DeepColour deep_colour(const AnyScalars& scalars) const = 0;
  /// The next ten are for an illumination that has a ramp.
  [[nodiscard]] virtual Cosine diffuse_scalar(const AnyScalars& scalars, std::uint32_t lit) const = 0;
  [[nodiscard]] virtual Cosine diffuse_sum(const AnyScalars& scalars) const = 0;
  [[nodiscard]] virtual PackedRgb diffuse_colour(Cosine normal_light) const = 0;
  [[nodiscard]] virtual std::uint32_t highlight_weight(std::size_t light) const = 0;
  [[nodiscard]] virtual std::uint32_t diffuse_share(std::size_t light) const = 0;
  [[nodiscard]] virtual bool draws_one_highlight() const = 0;
  [[nodiscard]] virtual OneHighlight one_highlight(std::size_t light) const = 0;
  [[nodiscard]] virtual std::uint32_t highlight_power(const OneHighlight& of, Cosine normal_light,
                                                      Cosine other) const = 0;
  [[nodiscard]] virtual PackedRgb highlight(std::uint32_t power) const = 0;
  [[nodiscard]] virtual std::uint32_t most_ramp() const = 0;
  [[nodiscard]] virtual bool lit_throughout(const AnyScalars& a, const AnyScalars& b, const AnyScalars& c,
                                            std::uint32_t& lit) const = 0;
  [[nodiscard]] virtual std::int32_t nearest_highlight_of(std::size_t light, const AnyScalars& a,
                                                          const AnyScalars& b, const AnyScalars& c,
                                                          Cosine headroom) const = 0;
  [[nodiscard]] virtual std::int32_t nearest_highlight_between(std::int32_t reach, const AnyScalars& a,
                                                               const AnyScalars& b, const AnyScalars& c,
                                                               std::uint32_t ab, std::uint32_t ac,
                                                               std::uint32_t bc) const = 0;
  [[nodiscard]] virtual HighlightBound highlights_over(const AnyScalars& a, const AnyScalars& b,
                                                       const AnyScalars& c, std::uint32_t ab,
                                                       std::uint32_t ac, std::uint32_t bc) const = 0;
  [[nodiscard]] virtual std::int32_t half_distance(Cosine normal_light, Cosine other,
                                                   std::size_t light) const = 0;
  [[nodiscard]] virtual std::int32_t rough_half_distance(Cosine normal_light, Cosine other,
                                                         std::size_t light) const = 0;
  [[nodiscard]] virtual bool may_clamp(bool shines) const = 0;
  [[nodiscard]] virtual std::uint32_t widest_patch() const = 0;
  [[nodiscard]] virtual Cosine fade_end() const = 0;
  [[nodiscard]] virtual std::uint32_t most_diffuse() const = 0;
  [[nodiscard]] virtual std::uint32_t most_specular() const = 0;
  [[nodiscard]] virtual std::uint32_t most_curvature() const = 0;
  [[nodiscard]] virtual std::uint32_t shininess() const = 0;
  [[nodiscard]] virtual const PowerTable& power() const = 0;
  [[nodiscard]] virtual const std::array<std::uint32_t, 3>& specular() const = 0;
};

/// The illumination by 1 to 4 lights that firmware uses: with a ramp unless one of several lights is
/// coloured. Throws Failure for other numbers of lights, and for materials and lights that
/// Illumination::make() rejects.
[[nodiscard]] std::unique_ptr<IlluminationCalls> make_any_illumination(
    const Material& material, std::span<const DirectionalLight> lights, const Direction& to_eye,
    Highlight model);

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
  explicit AnyIllumination(const IlluminationCalls& calls) : calls_(&calls) {}

  [[nodiscard]] std::size_t lights() const { return calls_->lights(); }
  [[nodiscard]] Highlight model() const { return calls_->model(); }
  [[nodiscard]] Scalars scalars(const Direction& normal) const { return calls_->scalars(normal); }
  [[nodiscard]] PackedRgb colour(const Scalars& scalars) const { return calls_->colour(scalars); }
  [[nodiscard]] PixelLight light(const Scalars& scalars) const { return calls_->light(scalars); }
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
  [[nodiscard]] std::uint32_t highlight_weight(std::size_t light) const requires HasRamp {
    return calls_->highlight_weight(light);
  }
  [[nodiscard]] std::uint32_t diffuse_share(std::size_t light) const requires HasRamp {
    return calls_->diffuse_share(light);
  }
  static constexpr bool kDrawsOneHighlight = HasRamp;
  [[nodiscard]] bool draws_one_highlight() const { return calls_->draws_one_highlight(); }
  [[nodiscard]] OneHighlight one_highlight(std::size_t light) const { return calls_->one_highlight(light); }
  [[nodiscard]] std::uint32_t highlight_power(const OneHighlight& of, Cosine normal_light,
                                              Cosine other) const {
    return calls_->highlight_power(of, normal_light, other);
  }
  [[nodiscard]] PackedRgb highlight(std::uint32_t power) const { return calls_->highlight(power); }
  [[nodiscard]] std::uint32_t most_ramp() const requires HasRamp { return calls_->most_ramp(); }
  [[nodiscard]] bool lit_throughout(const Scalars& a, const Scalars& b, const Scalars& c,
                                    std::uint32_t& lit) const {
    return calls_->lit_throughout(a, b, c, lit);
  }
  [[nodiscard]] bool may_shine(const Scalars& a, const Scalars& b, const Scalars& c, Cosine headroom) const {
    return nearest_highlight(a, b, c, headroom) < power().half_reach();
  }
  [[nodiscard]] std::int32_t nearest_highlight(const Scalars& a, const Scalars& b, const Scalars& c,
                                               Cosine headroom) const {
    std::int32_t nearest = INT32_MAX;
    for (std::size_t i = 0; i < kLights; ++i)
      nearest = std::min(nearest, nearest_highlight_of(i, a, b, c, headroom));
    return nearest;
  }
  /// INT32_MAX for a light that is not there.
  [[nodiscard]] std::int32_t nearest_highlight_of(std::size_t light, const Scalars& a, const Scalars& b,
                                                  const Scalars& c, Cosine headroom) const {
    return calls_->nearest_highlight_of(light, a, b, c, headroom);
  }
  [[nodiscard]] std::int32_t nearest_highlight_between(std::int32_t reach, const Scalars& a, const Scalars& b,
                                                       const Scalars& c, std::uint32_t ab, std::uint32_t ac,
                                                       std::uint32_t bc) const {
    return calls_->nearest_highlight_between(reach, a, b, c, ab, ac, bc);
  }
  [[nodiscard]] HighlightBound highlights_over(const Scalars& a, const Scalars& b, const Scalars& c,
                                               std::uint32_t ab, std::uint32_t ac, std::uint32_t bc) const {
    return calls_->highlights_over(a, b, c, ab, ac, bc);
  }
  [[nodiscard]] std::int32_t half_distance(Cosine normal_light, Cosine other, std::size_t light) const {
    return calls_->half_distance(normal_light, other, light);
  }
  [[nodiscard]] std::int32_t rough_half_distance(Cosine normal_light, Cosine other, std::size_t light) const {
    return calls_->rough_half_distance(normal_light, other, light);
  }
  [[nodiscard]] static constexpr std::size_t highlight_index(std::size_t light) { return kLights + light; }
  [[nodiscard]] bool may_clamp(bool shines) const { return calls_->may_clamp(shines); }
  [[nodiscard]] std::uint32_t widest_patch() const { return calls_->widest_patch(); }
  [[nodiscard]] Cosine fade_end() const { return calls_->fade_end(); }
  [[nodiscard]] std::uint32_t most_diffuse() const { return calls_->most_diffuse(); }
  [[nodiscard]] std::uint32_t most_specular() const { return calls_->most_specular(); }
  [[nodiscard]] std::uint32_t most_curvature() const { return calls_->most_curvature(); }
  [[nodiscard]] std::uint32_t shininess() const { return calls_->shininess(); }
  [[nodiscard]] const PowerTable& power() const { return calls_->power(); }
  [[nodiscard]] const std::array<std::uint32_t, 3>& specular() const { return calls_->specular(); }

 private:
  const IlluminationCalls* calls_;
};

}  // namespace arcspan::tools
