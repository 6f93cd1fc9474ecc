// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/arc_bound.hpp>
#include <arcspan/lighting/highlight_bound.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Which triangles may be patches, and bounds of their scalars.
namespace arcspan {

/// The limit of a patch's width and height in pixels. Up to there the rounding errors of second differences
/// add up to 2^-17, which changes a highlight of n = 64 by half an 8-bit step.
inline constexpr std::int32_t kLargestPatch = 128;

/// The squared chord of 33 degrees, 28 fraction bits, up to which a triangle without highlight may be a
/// patch: its N·L then is within one 8-bit step of bilinear SLERP (docs/accuracy.md). Small triangles may be
/// wider (SmallShading::diffuse_of()).
inline constexpr std::uint32_t kWidestDiffusePatch = 86613079u;

/// Largest estimated error of N·L up to which `Arc` draws a small triangle beyond kWidestDiffusePatch as a
/// patch: 0.78 8-bit steps, 5 fraction bits. Errors stay below 1.57 times the estimate.
inline constexpr std::uint32_t kPatchError = 25;

/// Returns an upper bound of the height of a scalar above its values at the vertices of a triangle whose
/// widest squared chord is s = `chord` (28 fraction bits): s/6 + 0.058 s^2 + 2^-12, for s at most 1
/// (arc_bound.hpp). 2^-12 is for the errors of patches and pieces.
[[nodiscard]] ARCSPAN_INLINE constexpr Cosine arc_headroom(std::uint32_t chord) {
  return Cosine::from_raw(detail::cap_height(chord) + (std::int32_t{1} << 18));
}

/// The squared chord of 30 degrees, 28 fraction bits, up to which triangles with a highlight may be patches.
inline constexpr std::uint32_t kWidestHighlightPatch = 71927064u;

/// Returns true if a patch of a triangle with these squared chords, of which `widest` is the widest, is as
/// accurate as that of an equilateral triangle with the squared chord `limit`; all have 28 fraction bits. The
/// error grows with the cube of the angle. Of triangles with the same widest chord, those with a right angle
/// have less than half of the equilateral one's error, and slender ones a third (decision 5).
[[nodiscard]] constexpr bool is_accurate_patch(const TriangleChords& chords, std::uint32_t widest,
                                               std::uint32_t limit) {
  if (widest <= limit) return true;
  if (widest > kWidestHighlightPatch || (widest >> 1) > limit) return false;
  return chords.sum() - widest <= limit + (limit >> 1) + (limit >> 3);
}

/// Returns true if a TriangleFrame, which is drawn by rows, is accurate as a patch; the other arguments are
/// as above. Beyond the limit it must be 4 pixels wide, because in narrower ones the second difference is so
/// large that the rounding of a row's start would show.
template <class Frame>
requires requires(const Frame& frame) { frame.chords; }
[[nodiscard]] constexpr bool is_accurate_patch(const Frame& frame, std::uint32_t widest,
                                               std::uint32_t limit) {
  if (widest <= limit) return true;
  return frame.width >= (std::uint32_t{4} << 16) && is_accurate_patch(frame.chords, widest, limit);
}

/// True if `Lighting` bounds its highlights over a triangle. Where they are faint, patches may be wider.
/// False for an EnvironmentMap, which has no highlights.
template <class Lighting>
concept BoundsHighlights = requires(const Lighting& lighting) {
  lighting.highlights_over({}, {}, {}, std::uint32_t{}, std::uint32_t{}, std::uint32_t{});
};

/// Returns the bounds of the highlights over a TriangleFrame or SortedVertices with chords of at most 1.
template <BoundsHighlights Lighting, class Triangle>
[[nodiscard]] ARCSPAN_OUTLINE constexpr HighlightBound highlights_over(const Lighting& lighting,
                                                                       const Triangle& triangle) {
  const TriangleChords& chords = triangle.chords;
  return lighting.highlights_over(triangle.top->shade.scalars, triangle.middle->shade.scalars,
                                  triangle.bottom->shade.scalars, chords.top_middle, chords.top_bottom,
                                  chords.middle_bottom);
}

/// Returns true if a triangle with this HighlightBound::slope is accurate as a patch. The other
/// arguments are those of is_accurate_patch(). Errors of rounding fall with the slope, too.
template <BoundsHighlights Lighting, class Triangle>
[[nodiscard]] constexpr bool is_accurate_patch_at_slope(const Lighting& lighting, const Triangle& triangle,
                                                        std::uint32_t widest, std::uint8_t slope) {
  return widest <= kWidestHighlightPatch &&
         is_accurate_patch(triangle, widest, limit_at_slope(lighting.widest_patch(), slope));
}

/// Returns true if the size of the triangle allows a patch: a width of at least half a pixel, because slopes
/// of narrower triangles do not fit a Cosine, and a width and height below kLargestPatch.
template <class Method>
[[nodiscard]] constexpr bool patch_fits(const TriangleFrame<Method>& frame) {
  return frame.width >= (1u << 15) && frame.width < (static_cast<std::uint32_t>(kLargestPatch) << 16) &&
         frame.long_edge.dy < (kLargestPatch << Subpixel::kFraction);
}

}  // namespace arcspan
