// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_bound.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Which highlights reach a triangle, and how wide a patch they allow.
namespace arcspan {

/// The highlights of a triangle.
struct NearestHighlight {
  std::int32_t distance;  ///< a lower bound of the half distance: (1 - c) / 2 of the highlight's cosine c
  /// The only light whose highlight is above half the tolerance and within reach; kLights if no light or
  /// several have such a highlight. Always 0 with one light.
  std::size_t light;
};

/// Returns the NearestHighlight of a TriangleFrame; `Lighting` is an AdaptiveIllumination.
template <class Lighting, class Frame>
[[nodiscard]] constexpr NearestHighlight nearest_highlight(const Lighting& lighting, const Frame& frame) {
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const Cosine headroom = arc_headroom(frame.chords.widest());
  if constexpr (Lighting::kLights == 1) {
    return {lighting.nearest_highlight(top, middle, bottom, headroom), 0};
  } else {
    NearestHighlight nearest{INT32_MAX, Lighting::kLights};
    bool shines = false;
    for (std::size_t i = 0; i < Lighting::kLights; ++i) {
      const std::int32_t distance = lighting.nearest_highlight_of(i, top, middle, bottom, headroom);
      if (distance < nearest.distance) nearest.distance = distance;
      if (distance >= lighting.half_tolerance_reach()) continue;
      nearest.light = shines ? Lighting::kLights : i;
      shines = true;
    }
    return nearest;
  }
}

/// The result of bounding the highlights of a triangle beyond widest_patch().
struct WidePatch {
  std::int32_t nearest;  ///< NearestHighlight::distance
  bool fits;             ///< the triangle may be a patch
};

/// Returns the WidePatch of a TriangleFrame. `widest` is its widest squared chord, 28 fraction bits, and
/// `nearest` its NearestHighlight::distance without that bound.
template <class Lighting, class Frame>
[[nodiscard]] ARCSPAN_OUTLINE constexpr WidePatch wide_patch_of(const Lighting& lighting, const Frame& frame,
                                                                std::uint32_t widest, std::int32_t nearest) {
  if (!patch_fits(frame)) return {nearest, false};
  const HighlightBound bound = highlights_over(lighting, frame);
  return {bound.nearest > nearest ? bound.nearest : nearest,
          is_accurate_patch_at_slope(lighting, frame, widest, bound.slope)};
}

}  // namespace arcspan
