// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Draws a run piece by piece (PiecewiseRun).
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_pieces(PixelPlace<Target>& place, const Span& span, Run& run,
                                          const Target& target, Linear dz) {
  for (std::int32_t left = span.count; left > 0;) {
    const std::int32_t count = run.enter(left);
    if constexpr (IndexedRows<Target>) {
      place.cursor.skip(count);
      place.depths += count;
    }
    const Span piece{span.y, span.x + span.count - left, count};
    draw_pixels(place, piece, run, target, dz, first_index(piece));
    left -= count;
  }
}

/// Draws a run that consists of segments with linear colours (SegmentedRun).
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_segments(PixelPlace<Target>& place, const Span& span, Run& run,
                                            const Target& target, Linear dz) {
  run.begin(target.lighting, span.count);
  for (std::int32_t left = span.count; left > 0;) {
    const std::int32_t count = run.enter(target.lighting, left);
    if constexpr (IndexedRows<Target>) {
      place.cursor.skip(count);
      place.depths += count;
    }
    auto segment = run.segment();
    const Span piece{span.y, span.x + span.count - left, count};
    draw_pixels(place, piece, segment, target, dz, first_index(piece));
    left -= count;
  }
}

}  // namespace arcspan::detail
