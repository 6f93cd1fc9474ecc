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
  std::uint32_t inside;  ///< distance in pixels from the left edge to the first pixel, `bits` fraction bits
  std::uint32_t width;   ///< length of the whole row in pixels, `bits` fraction bits; raw value at least 1
  int bits;              ///< 16, or 32 for rows shorter than a pixel
  std::int32_t column;   ///< of the first pixel, in the picture; not negative
};

/// Returns the start of the row between two edges at `column`, `skipped` columns after its first column.
[[nodiscard]] ARCSPAN_INLINE constexpr RowStart row_start(const EdgeWalk& left, const EdgeWalk& right,
                                                          std::int32_t skipped, std::int32_t column) {
  const std::uint32_t fraction = left.fraction();
  const std::uint32_t fine = left.fine_fraction();
  const std::int64_t width = right.x - left.x;
  if ((width >> 32) != 0) {
    return {fraction,
            fine,
            skipped,
            fraction + (static_cast<std::uint32_t>(skipped) << 16),
            static_cast<std::uint32_t>(width >> 16),
            16,
            column};
  }
  const auto narrow = static_cast<std::uint32_t>(width);
  return {fraction, fine, skipped, fine, narrow | static_cast<std::uint32_t>(narrow == 0), 32, column};
}

}  // namespace arcspan
