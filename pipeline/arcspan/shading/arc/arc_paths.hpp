// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/small_shading.hpp>
#include <arcspan/shading/arc/wide_walker.hpp>
#include <arcspan/shading/patch/diffuse_scalars.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The paths of ArcUpTo, and the choice among them.
template <class Illumination, WidestNormals kWidest>
struct ArcPaths {
  enum class Path : std::uint8_t {
    kPatch,            ///< a patch of every scalar
    kDiffusePatch,     ///< a patch of N·L only; no highlight is within reach
    kDiffuseSumPatch,  ///< a patch of N·L of every light; no highlight is within reach, and one of several
                       ///< grey lights reaches a part of the triangle
    kSteppedDistance,  ///< a patch for SteppedDistanceRun; Blinn's highlight of one light is within reach
    kOneHighlight,  ///< a patch for OneHighlightRun; the highlight of one of several lights is within reach
    kWide,          ///< rows in pieces: normals too far apart for a patch, slivers, triangles larger than
                    ///< kLargestPatch, the fade of Blinn's highlight
    kDiffuseWide,   ///< rows in pieces, N·L only
    kDark,          ///< no light reaches the triangle
  };

 protected:
  static constexpr bool kHasDiffusePath = Illumination::kHasRamp;
  /// True if dark triangles have a path. Programs that are limited by WidestNormals leave its loop out.
  static constexpr bool kDrawsDark = kHasDiffusePath && kWidest == WidestNormals::kAny;
  static constexpr bool kSumsLights = kMaySumLights<kWidest> && kHasDiffusePath && Illumination::kLights > 1;
  static constexpr bool kFindsFaintHighlights = kWidest != WidestNormals::kWithinPatches;
  /// True if wide triangles without highlight carry N·L only. That is only faster; the colours are the same.
  static constexpr bool kHasDiffuseWide = Illumination::kLights == 1 && !kOptimisedForSize;

  /// Returns true if no light reaches a triangle.
  template <class Frame>
  [[nodiscard]] static constexpr bool is_dark(const Frame& frame) {
    return SmallShading<Illumination>::is_dark(frame.top->shade.scalars, frame.middle->shade.scalars,
                                               frame.bottom->shade.scalars);
  }

  /// Returns true if a triangle without highlight can be drawn by diffuse_path().
  template <class Frame>
  [[nodiscard]] static constexpr bool has_diffuse_path(const Illumination& lighting, const Frame& frame) {
    std::uint32_t lit = 0;
    return kSumsLights || lit_throughout(lighting, frame, lit);
  }

  /// Returns the path of a triangle without highlight that has_diffuse_path(); `fits` is patch_fits().
  template <class Frame>
  [[nodiscard]] static constexpr Path diffuse_path(const Illumination& lighting, const Frame& frame,
                                                   bool fits, std::uint32_t widest) {
    if (kDrawsDark && is_dark(frame)) return Path::kDark;
    if (!fits || widest > kWidestDiffusePatch) return kHasDiffuseWide ? Path::kDiffuseWide : Path::kWide;
    if constexpr (kSumsLights) {
      std::uint32_t lit = 0;
      if (!lit_throughout(lighting, frame, lit)) return Path::kDiffuseSumPatch;
    }
    return Path::kDiffusePatch;
  }

  /// Returns the path of a triangle whose normals are more than 60 degrees apart.
  template <class Frame>
  [[nodiscard]] static constexpr Path wide_path(const Frame& frame) {
    return kDrawsDark && is_dark(frame) ? Path::kDark : Path::kWide;
  }

  /// Returns the path of a triangle; `widest` is its widest squared chord, 28 fraction bits.
  template <class Frame>
  [[nodiscard]] static constexpr Path choose_path(const Illumination& lighting, const Frame& frame,
                                                  std::uint32_t widest) {
    if (widest > kWidestArc) return wide_path(frame);
    const bool fits = patch_fits(frame);
    if constexpr (kHasDiffusePath) {
      if (!lighting.may_shine(frame.top->shade.scalars, frame.middle->shade.scalars,
                              frame.bottom->shade.scalars, arc_headroom(widest)) &&
          has_diffuse_path(lighting, frame))
        return diffuse_path(lighting, frame, fits, widest);
    }
    if (!fits) return Path::kWide;
    if (is_accurate_patch(frame, widest, lighting.widest_patch())) return Path::kPatch;
    if constexpr (BoundsHighlights<Illumination> && kFindsFaintHighlights)
      return path_by_highlight(lighting, frame, widest);
    return Path::kWide;
  }

  /// Returns the path of a triangle beyond widest_patch(), by how bright its highlights are.
  template <class Frame>
  [[nodiscard]] ARCSPAN_OUTLINE static constexpr Path path_by_highlight(const Illumination& lighting,
                                                                        const Frame& frame,
                                                                        std::uint32_t widest) {
    const HighlightBound bound = highlights_over(lighting, frame);
    if constexpr (kHasDiffusePath) {
      if (bound.nearest >= lighting.power().half_reach() && has_diffuse_path(lighting, frame))
        return diffuse_path(lighting, frame, true, widest);
    }
    const bool is_patch = is_accurate_patch_at_slope(lighting, frame, widest, bound.slope);
    return is_patch ? Path::kPatch : Path::kWide;
  }
};

}  // namespace arcspan
