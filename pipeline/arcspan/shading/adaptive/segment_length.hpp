// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// How long the segments of Adaptive may be (path 3 of AdaptivePaths).
namespace arcspan {

/// The longest segments have 2^kLongestSegmentBits = 16 pixels.
inline constexpr int kLongestSegmentBits = 4;
/// The shortest segments have 2^kLeastSegmentBits = 4 pixels.
inline constexpr int kLeastSegmentBits = 2;
/// The width of a triangle's widest row from which on it may have segments: four of the shortest.
inline constexpr std::uint32_t kLeastWidthOfSegments = 4u << kLeastSegmentBits;

/// Returns true if every N·L keeps its sign over the triangle and stays out of the fade of the highlights,
/// by a margin whose square is `margin2` (28 fraction bits). At a change of sign, colours have a kink and
/// highlights end abruptly or fade. The margin is needed because a segment may end up to a quarter of a row
/// beyond the edge.
template <class Lighting, class Frame>
[[nodiscard]] constexpr bool away_from_terminator(const Lighting& lighting, const Frame& frame,
                                                  std::uint32_t margin2) {
  const std::int32_t fade_end = lighting.fade_end().raw();
  const auto square = [fade_end](std::int32_t v) {
    const std::int32_t away = v <= 0 ? v : v > fade_end ? v - fade_end : 0;
    return static_cast<std::uint32_t>(wrap_mul(away >> 16, away >> 16));
  };
  for (std::size_t i = 0; i < lighting.lights(); ++i) {
    const std::int32_t a = frame.top->shade.scalars[i].raw();
    const std::int32_t b = frame.middle->shade.scalars[i].raw();
    const std::int32_t c = frame.bottom->shade.scalars[i].raw();
    if (((a ^ b) | (b ^ c)) < 0) return false;
    if (square(a) <= margin2 || square(b) <= margin2 || square(c) <= margin2) return false;
  }
  return true;
}

/// Returns the bits of the longest segments that the tolerance allows and of which the triangle's widest
/// row, of at least kLeastWidthOfSegments pixels, holds at least four; 0 if there are none. `shines` is true
/// if a highlight above half the tolerance is within reach.
template <class Lighting, class Frame>
[[nodiscard]] constexpr int longest_segment_bits(const Lighting& lighting, const Frame& frame, bool shines) {
  const TriangleChords& chords = frame.chords;
  const std::uint32_t whole = frame.width >> 16;
  // The angle of the widest row is at most that of the wider edge at the middle vertex. The pixels of a row
  // are not quite evenly spaced in angle; reducing the limit by a quarter covers that.
  const std::uint32_t limit = lighting.segment_limit(shines);
  const std::uint32_t width = whole > 1023 ? 1023 : whole;
  const std::uint32_t across =
      chords.top_middle > chords.middle_bottom ? chords.top_middle : chords.middle_bottom;
  if (!away_from_terminator(lighting, frame, across >> 4)) return 0;
  const std::uint32_t allowed = (limit >> 8) - (limit >> 10);
  const std::uint64_t room = static_cast<std::uint64_t>(allowed) * (width * width);
  for (int bits = kLongestSegmentBits; bits >= kLeastSegmentBits; --bits) {
    if ((width >> bits) >= 4 && (static_cast<std::uint64_t>(across >> 8) << (2 * bits)) <= room) return bits;
  }
  return 0;
}

}  // namespace arcspan
