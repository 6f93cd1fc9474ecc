// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/patch_walker.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The pixels of a row (PixelRun) with the highlight of one light. Second differences step both
/// diffuse_scalar() and the highlight's scaled distance (HighlightTable), so no product is computed per pixel
/// (decision 7).
template <class Lighting>
class HighlightPatchRun : public SecondDifferenceRun<2> {
 public:
  static constexpr std::size_t kUsed = 2;

  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb colour(const Lighting& lighting) const {
    return lighting.colour_with_highlight_at(scalars()[0], scalars()[1].raw(), weight());
  }
  /// Returns the parts of colour() (LightRun).
  [[nodiscard]] ARCSPAN_INLINE constexpr PixelLight light(const Lighting& lighting) const {
    return lighting.light_with_highlight_at(scalars()[0], scalars()[1].raw(), weight());
  }
  /// Returns colour() encoded in `Format`; `encoded` is an EncodedColourTable (EncodingRun).
  template <class Format, class Colours>
  [[nodiscard]] ARCSPAN_INLINE constexpr typename Format::Encoded encoded(const Lighting& lighting,
                                                                          const Colours& encoded) const {
    if constexpr (Colours::kForHighlights) {
      return lighting.template encoded_with_highlight_at<Format>(scalars()[0], scalars()[1].raw(), weight(),
                                                                 encoded);
    } else {
      return encode_varying<Format>(colour(lighting));
    }
  }
  constexpr void set_weight(std::uint32_t weight) {
    if constexpr (Lighting::kLights > 1) weight_[0] = weight;
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t weight() const {
    if constexpr (Lighting::kLights > 1) return weight_[0];
    return std::uint32_t{1} << 15;
  }
  std::array<std::uint32_t, Lighting::kLights == 1 ? 0 : 1> weight_;  ///< highlight_weight() of its light
};

/// Steps a highlight patch (RowWalker).
template <class Lighting, std::size_t Count>
class HighlightPatchWalker : public PatchWalker<HighlightPatchRun<Lighting>, Count> {
 public:
  using Base = PatchWalker<HighlightPatchRun<Lighting>, Count>;
  using typename Base::Run;

  constexpr HighlightPatchWalker(Patch<Count>& patch, bool middle_left, std::uint32_t weight)
      : Base(patch, middle_left), weight_(weight) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr Run row(const RowStart& start) const {
    Run run = Base::row(start);
    run.set_weight(weight_);
    return run;
  }

 private:
  std::uint32_t weight_;
};

}  // namespace arcspan
