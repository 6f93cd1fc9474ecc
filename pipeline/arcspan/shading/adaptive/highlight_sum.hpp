// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/adaptive/highlight_factors.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Highlights R·V of several grey lights, of which one or more are within reach, where no diffuse scalar or
/// no surface of the half distance suffices (decision 28).
namespace arcspan {

/// product_origin() of each light.
template <std::size_t Lights>
using ProductOrigins = std::array<std::int32_t, Lights>;

/// The pixels of a row (PixelRun), coloured from N·L of every light and N·V in the scale of distances, all
/// raised by HighlightFactors::kHalf.
template <class Lighting>
class HighlightSumRun : public SecondDifferenceRun<Lighting::kLights + 1> {
 public:
  static constexpr std::size_t kUsed = Lighting::kLights + 1;
  static constexpr std::size_t kEye = Lighting::kLights;
  using Origins = ProductOrigins<Lighting::kLights>;

  constexpr void set_origins(const Origins& origins) { origins_ = &origins; }

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    const Sums sums = this->sums(lighting);
    const PackedRgb diffuse = lighting.diffuse_colour(sums.diffuse());
    return sums.highlight == 0 ? diffuse : diffuse.plus(lighting.highlight_table().of_sum(sums.highlight));
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    const Sums sums = this->sums(lighting);
    return {lighting.diffuse_colour(sums.diffuse()),
            sums.highlight == 0 ? PackedRgb{} : lighting.highlight_table().of_sum(sums.highlight)};
  }

 private:
  struct Sums {
    std::uint32_t light = 0;      ///< diffuse_sum(), 30 fraction bits
    std::uint32_t highlight = 0;  ///< largest channel, in 8-bit steps with 8 fraction bits
    [[nodiscard]] constexpr Cosine diffuse() const {
      return Cosine::from_raw(static_cast<std::int32_t>(light));
    }
  };

  [[nodiscard]] ARCSPAN_INLINE constexpr Sums sums(const Lighting& lighting) const {
    Sums sums;
    add<0>(lighting, sums);
    return sums;
  }
  /// Adds the lights from I on. Not by unrolled(), whose function -Os would call.
  template <std::size_t I>
  ARCSPAN_INLINE constexpr void add(const Lighting& lighting, Sums& sums) const {
    if (const std::int32_t raised = this->scalars()[I].raw(); raised >= kLeastLit) {
      const std::int32_t light = raised >> 15;
      sums.light += static_cast<std::uint32_t>(light) * lighting.diffuse_share(I);
      const std::int32_t distance =
          wrap_sub((*origins_)[I], wrap_mul(light, this->scalars()[kEye].raw() >> 15));
      if (distance < HighlightTable::kReach)
        sums.highlight += (lighting.highlight_table().value(distance) * lighting.highlight_weight(I)) >> 15;
    }
    if constexpr (I + 1 < Lighting::kLights) add<I + 1>(lighting, sums);
  }

  /// Arc counts N·L of at least 2^-15 as lit; here it is raised. The limit is the same because highlights of
  /// low exponents end there abruptly.
  static constexpr std::int32_t kLeastLit = (std::int32_t{1} << 15) + HighlightFactors::kHalf.raw();

  const Origins* origins_;
};

/// Steps a patch of a HighlightSumRun (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightSumWalker : public PatchWalker<HighlightSumRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightSumRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr HighlightSumWalker(Patch<Count>& patch, bool middle_left, const typename Run::Origins& origins)
      : Base(patch, middle_left), origins_(&origins) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_origins(*origins_);
    return run;
  }

 private:
  const typename Run::Origins* origins_;
};

/// Prepares a HighlightSumWalker for a TriangleFrame.
template <class Lighting, class Frame, std::size_t Count>
constexpr void prepare_sum(const Lighting& lighting, const Frame& frame, Patch<Count>& patch,
                           ProductOrigins<Lighting::kLights>& origins) {
  const EdgeSagittaFactors factors = sagitta_factors_of(frame.chords);
  for (std::size_t i = 0; i < Lighting::kLights; ++i) {
    make_factor_surface(frame, factors, values_of(frame, i), patch[i]);
    if (i < lighting.lights()) origins[i] = product_origin(lighting, i);  // the others never light a pixel
  }
  make_factor_surface(frame, factors, scaled_eye_of(lighting, frame, 0),
                      patch[HighlightSumRun<Lighting>::kEye]);
}

}  // namespace arcspan
