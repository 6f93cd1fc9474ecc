// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The unit of slopes along rows: a pixel, or in slivers the width at the middle vertex. Slivers are
/// triangles narrower than a pixel: per pixel their slopes would overflow, and no slope is stepped in a row
/// of one pixel.
struct SlopeUnit {
  bool is_sliver;
  std::uint8_t exponent;   ///< in slivers: of 1/width, where the width has 32 fraction bits
  std::uint32_t mantissa;  ///< of the same reciprocal

  /// Returns the distance from an edge to the centre of its column in this unit: 16 fraction bits, below 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t distance(const EdgeWalk& left) const {
    if (is_sliver) [[unlikely]]
      return over_width(left);
    return left.fraction();
  }

 private:
  [[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD constexpr std::uint32_t over_width(const EdgeWalk& left) const {
    const std::uint32_t fine = left.fine_fraction();
    // The product fits 32 bits if the row has a pixel. Exactly, `fine` is then below the width at the middle
    // vertex, which is 2^-19 pixels or more. Edges are off by up to 2^-21 (EdgeWalk): it is below twice that.
    const int bits = exponent - 15;  // bits that the width has: 1...32
    const std::uint32_t upper = bits > 16 ? fine >> (bits - 16) : fine << (16 - bits);
    const std::uint32_t fraction = (upper * (mantissa >> 1)) >> 14;
    return fraction < 0xFFFFu ? fraction : 0xFFFFu;
  }
};

/// The position of a row's first pixel, from which the method's walker starts the row (RowWalker).
struct RowStart {
  /// From the left edge to the centre of the first column inside the triangle, in the SlopeUnit.
  std::uint32_t distance;
  std::uint32_t fraction;  ///< the same distance in pixels, 16 fraction bits, below 1
  std::uint32_t fine;      ///< in pixels with 32 fraction bits
  /// Columns from that column to the first pixel. Above 0 if the scissor cuts the row on the left.
  std::int32_t skipped;
  std::int32_t column;  ///< of the first pixel, in the picture; not negative
  std::int64_t width;   ///< length of the whole row in pixels, 32 fraction bits
};

/// Returns the start of the row between two edges at `column`, `skipped` columns after its first column.
[[nodiscard]] ARCSPAN_INLINE constexpr RowStart row_start(const SlopeUnit& unit, const EdgeWalk& left,
                                                          const EdgeWalk& right, std::int32_t skipped,
                                                          std::int32_t column) {
  return {unit.distance(left), left.fraction(), left.fine_fraction(), skipped, column, right.x - left.x};
}

}  // namespace arcspan
