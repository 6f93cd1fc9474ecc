// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A row of a triangle as its method's walker gets it.
struct RowStart {
  /// From the left edge to the centre of the row's first column, in pixels with 16 fraction bits, below 1.
  std::uint32_t fraction;
  /// How many columns the first pixel lies beyond that one: where the row is cut on the left, or begun anew.
  std::int32_t skipped;
  /// The same distance to the first pixel, and the whole row's length, at least 1, both with `bits` fraction
  /// bits: 16, or 32 for rows shorter than a pixel.
  std::uint32_t inside;
  std::uint32_t width;
  int bits;
};

[[nodiscard]] ARCSPAN_INLINE constexpr RowStart row_start(const EdgeWalk& left, const EdgeWalk& right,
                                                          std::int32_t skipped) {
  const std::uint32_t fraction = left.fraction();
  const std::int64_t width = right.x - left.x;
  if ((width >> 32) != 0) {
    return {fraction, skipped, fraction + (static_cast<std::uint32_t>(skipped) << 16),
            static_cast<std::uint32_t>(width >> 16), 16};
  }
  const auto narrow = static_cast<std::uint32_t>(width);
  return {fraction, skipped, left.fine_fraction(), narrow | static_cast<std::uint32_t>(narrow == 0), 32};
}

}  // namespace arcspan
