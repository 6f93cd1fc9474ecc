// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/arc_shape.hpp>
#include <arcspan/literature/highlights_over.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/surface/chords.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// How the scalars of a triangle follow its normals in Segment.
enum class SegmentPath : std::uint8_t {
  kPatch,            ///< a patch of every scalar
  kDiffusePatch,     ///< a patch of the diffuse_scalar(); no highlight is within reach
  kDiffuseSumPatch,  ///< a patch of N·L of every light; no highlight is within reach, and one of several grey
                     ///< lights reaches a part of the triangle
  kDark,      ///< no light reaches the triangle
  kWide,      ///< rows in pieces: normals too far apart for a patch, slivers, large triangles
  kVeryWide,  ///< rows in pieces: normals more than 60 degrees apart
};

/// The limit of a patch's width and height in pixels. Up to there the rounding errors of second differences
/// add up to 2^-17, which changes a highlight of n = 64 by half an 8-bit step.
inline constexpr std::int32_t kLargestPatch = 128;
/// The squared chord of 33 degrees, 28 fraction bits, up to which a triangle without highlight may be a
/// patch.
inline constexpr std::uint32_t kWidestDiffusePatch = 86613079u;
/// The squared chord of 30 degrees, 28 fraction bits, up to which triangles with a highlight may be patches.
inline constexpr std::uint32_t kWidestHighlightPatch = 71927064u;

/// Returns the squared angle in rad^2 of the widest piece, for a lighting that allows patches up to the
/// squared chord `widest_patch` (28 fraction bits). Pieces may be 1.3 times as wide as patches for the same
/// error, because a parabola differs from an arc by less than a patch from a spherical
/// triangle.
[[nodiscard]] constexpr Factor widest_piece(std::uint32_t widest_patch) {
  const std::uint32_t angle2 = widest_patch >> 13;
  return Factor::from_raw(static_cast<std::int32_t>(angle2 + (angle2 >> 1) + (angle2 >> 3)));
}

/// Returns true if the size of the triangle allows a patch: a width of at least half a pixel, because slopes
/// of narrower triangles do not fit a Cosine, and a width and height below kLargestPatch.
template <class Frame>
[[nodiscard]] constexpr bool has_size_of_patch(const Frame& frame) {
  return frame.width >= (1u << 15) && frame.width < (static_cast<std::uint32_t>(kLargestPatch) << 16) &&
         frame.long_edge.dy < (kLargestPatch << Subpixel::kFraction);
}

/// Returns true if a triangle is as accurate as a patch as an equilateral one with the squared chord `limit`
/// (28 fraction bits). The error grows with the cube of the angle. Of triangles with the same widest chord,
/// those with a right angle have less than half of the equilateral one's error, and slender ones a third.
/// Beyond the limit the triangle must be 4 pixels wide, because in narrower ones the second
/// difference is so large that the rounding of a row's start would show.
template <class Frame>
[[nodiscard]] constexpr bool is_accurate_as_patch(const Frame& frame, std::uint32_t limit) {
  const std::uint32_t widest = frame.chords.widest();
  if (widest <= limit) return true;
  if (frame.width < (std::uint32_t{4} << 16)) return false;
  if (widest > kWidestHighlightPatch || (widest >> 1) > limit) return false;
  return frame.chords.sum() - widest <= limit + (limit >> 1) + (limit >> 3);
}

/// Returns true if no light reaches a triangle: N·L of none is above 0 at a vertex. For lightings with a
/// ramp.
template <class Lighting, class Frame>
[[nodiscard]] constexpr bool is_dark(const Lighting&, const Frame& frame) {
  for (std::size_t i = 0; i < Lighting::kLights; ++i) {
    if (frame.top->shade.scalars[i].raw() > 0 || frame.middle->shade.scalars[i].raw() > 0 ||
        frame.bottom->shade.scalars[i].raw() > 0) {
      return false;
    }
  }
  return true;
}

/// Returns the path of a triangle without highlight: dark, a patch, or wide. Sets `lit` for
/// lighting.diffuse_scalar() if the path is kDiffusePatch.
template <class Lighting, class Frame>
[[nodiscard]] constexpr SegmentPath diffuse_segment_path(const Lighting& lighting, const Frame& frame,
                                                         bool fits, std::uint32_t& lit) {
  if (literature::is_dark(lighting, frame)) return SegmentPath::kDark;
  if (!fits || frame.chords.widest() > kWidestDiffusePatch) return SegmentPath::kWide;
  return lighting.lit_throughout(frame.top->shade.scalars, frame.middle->shade.scalars,
                                 frame.bottom->shade.scalars, lit)
             ? SegmentPath::kDiffusePatch
             : SegmentPath::kDiffuseSumPatch;
}

/// Returns the path of a triangle, and sets `lit` as diffuse_segment_path() does.
template <class Lighting, class Frame>
[[nodiscard]] ARCSPAN_OUTLINE constexpr SegmentPath choose_segment_path(const Lighting& lighting,
                                                                        const Frame& frame,
                                                                        std::uint32_t& lit) {
  const NormalChords& chords = frame.chords;
  const std::uint32_t widest = chords.widest();
  if (widest > kWidestArc) {
    if constexpr (Lighting::kHasRamp) {
      if (literature::is_dark(lighting, frame)) return SegmentPath::kDark;
    }
    return SegmentPath::kVeryWide;
  }
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  const bool fits = has_size_of_patch(frame);
  if constexpr (Lighting::kHasRamp) {
    // 2^-12 is for the errors of patches and pieces.
    const auto headroom = Cosine::from_raw(arcspan::detail::cap_height(widest) + (std::int32_t{1} << 18));
    if (!may_shine(lighting, top, middle, bottom, headroom))
      return diffuse_segment_path(lighting, frame, fits, lit);
  }
  if (!fits) return SegmentPath::kWide;
  if (is_accurate_as_patch(frame, lighting.widest_patch())) return SegmentPath::kPatch;
  const HighlightBound bound = highlights_over(lighting, top, middle, bottom, chords.top_middle,
                                               chords.top_bottom, chords.middle_bottom);
  if constexpr (Lighting::kHasRamp) {
    if (bound.nearest >= lighting.power().half_reach())
      return diffuse_segment_path(lighting, frame, true, lit);
  }
  const bool is_patch = widest <= kWidestHighlightPatch &&
                        is_accurate_as_patch(frame, limit_at_slope(lighting.widest_patch(), bound.slope));
  return is_patch ? SegmentPath::kPatch : SegmentPath::kWide;
}

}  // namespace arcspan::literature
