// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// Draws the pixels of a whole run in an indexed row. The column behind it is extended to an index once, from
/// which both addresses and the first index follow by one instruction each.
template <class Target, class Run>
ARCSPAN_INLINE constexpr void draw_indexed_run(const RowMemory<Target>& memory, const Span& span, Linear z,
                                               Run& run, const Target& target, Linear dz) {
  if constexpr (kHasWideRegisters && SinkInMemory<typename Target::Sink>) {
    const std::int32_t behind = span.x + span.count;
    auto end = static_cast<std::ptrdiff_t>(behind);
    hide_value(end);
    const auto cursor = memory.pixels.at_column(end);
    hide_value(end);
    PixelPlace<Target> place{cursor, memory.depths.at_column(end), z};
    draw_pixels_from(place, span, static_cast<std::ptrdiff_t>(span.x) - end, run, target, dz);
  } else {
    PixelPlace<Target> place{memory.pixels.behind(span), memory.depths.behind(span), z};
    draw_pixels(place, span, run, target, dz);
  }
}

}  // namespace arcspan::detail
