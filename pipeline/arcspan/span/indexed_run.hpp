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

/// Where the pixels of a whole run in an indexed row lie: what draw_pixels() takes.
template <class Target>
struct IndexedRun {
  PixelPlace<Target> place;
  std::ptrdiff_t first;
};

/// Returns the place of a run that begins at the depth `z`. On 64-bit machines the column behind it is
/// extended to an index once, from which both addresses and the first index follow by one instruction each.
template <class Target>
[[nodiscard]] ARCSPAN_INLINE constexpr IndexedRun<Target> indexed_run(const RowMemory<Target>& memory,
                                                                      const Span& span, Linear z) {
  if constexpr (kHasWideRegisters && SinkInMemory<typename Target::Sink>) {
    const std::int32_t behind = span.x + span.count;
    auto end = static_cast<std::ptrdiff_t>(behind);
    hide_value(end);
    const auto cursor = memory.pixels.at_column(end);
    hide_value(end);
    return {{cursor, memory.depths.at_column(end), z}, static_cast<std::ptrdiff_t>(span.x) - end};
  } else {
    return {{memory.pixels.behind(span), memory.depths.behind(span), z}, first_index(span)};
  }
}

}  // namespace arcspan::detail
