// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Optional part of a method (`kNeedsNearOverW`), for attributes in perspective: its vertices have near/w,
/// and its Prepared, which depends on the columns of pixels in the picture, has move_columns(pixels).
template <class M>
concept NeedsNearOverW = bool{M::kNeedsNearOverW};

/// The command that preparation passes to the span stage. It consists of integers without pointers and is all
/// that passes between the two, so the span stage may be another core or hardware.
/// docs/triangle-command.md describes its layout.
///
/// Rows first_row ... end_row - 1 lie between `left` and `right`. At middle_row `lower` replaces the edge on
/// the side of the middle vertex. Each edge holds its x at the first row that uses it.
template <class Method>
struct TriangleCommand {
  std::int16_t first_row;   ///< relative to the raster origin, as the other two
  std::int16_t middle_row;  ///< first row of the lower half
  std::int16_t end_row;     ///< row after the last
  bool middle_left;         ///< the middle vertex is on the left of the long edge
  SlopeUnit unit;
  EdgeWalk left;
  EdgeWalk right;
  EdgeWalk lower;
  LinearPlane depth;
  typename Method::Prepared shade;

  /// Returns true if one of the command's rows is among top ... bottom - 1, where `origin` is the row of the
  /// raster origin.
  [[nodiscard]] constexpr bool has_rows_in(std::int32_t top, std::int32_t bottom, std::int32_t origin) const {
    return end_row + origin > top && first_row + origin < bottom;
  }
  /// Moves everything by `pixels` columns.
  ARCSPAN_INLINE constexpr void move_columns(std::int32_t pixels) {
    const auto shift = static_cast<std::int64_t>(static_cast<std::uint64_t>(pixels) << 32);
    left.x += shift;
    right.x += shift;
    lower.x += shift;
    if constexpr (NeedsNearOverW<Method>) shade.move_columns(pixels);
  }
};

}  // namespace arcspan
