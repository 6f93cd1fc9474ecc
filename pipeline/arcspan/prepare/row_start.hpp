// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The position of a row's first pixel, from which the method's walker starts the row (RowWalker).
struct RowStart {
  /// Distance in pixels from the left edge to the centre of the first column inside the triangle: 16 fraction
  /// bits, 0 or more and below 1.
  std::uint32_t fraction;
  std::uint32_t fine;  ///< the same distance with 32 fraction bits
  /// Columns from that column to the first pixel. Above 0 if the scissor cuts the row on the left.
  std::int32_t skipped;
  std::int32_t column;  ///< of the first pixel, in the picture; not negative
  std::int64_t width;   ///< length of the whole row in pixels, 32 fraction bits
};

/// Returns the start of the row between two edges at `column`, `skipped` columns after its first column.
[[nodiscard]] ARCSPAN_INLINE constexpr RowStart row_start(const EdgeWalk& left, const EdgeWalk& right,
                                                          std::int32_t skipped, std::int32_t column) {
  return {left.fraction(), left.fine_fraction(), skipped, column, right.x - left.x};
}

}  // namespace arcspan
