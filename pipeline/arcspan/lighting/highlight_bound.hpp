// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// Bounds of the highlights over a triangle. The slope of a highlight is that of c^n by c, as a part of the
/// slope at c = 1; those of several lights are added by their weights.
struct HighlightBound {
  std::int32_t nearest;  ///< least half distance (PowerTable); INT32_MAX if no light reaches the triangle
  /// The sum of the slopes is at most (slope + 1) / 16 of that of the weights; 15 if it may be all.
  std::uint8_t slope;

  static constexpr std::uint8_t kBrightest = 15;
};

namespace detail {
/// Entry i is (16 / (i + 1))^(2/3) with 4 fraction bits, rounded down. Not a variable of the function,
/// because gcc would copy it to the stack.
inline constexpr std::array<std::uint8_t, 16> kWiderAtSlope{101, 64, 48, 40, 34, 30, 27, 25,
                                                            23,  21, 20, 19, 18, 17, 16, 16};
}  // namespace detail

/// Returns the squared chord (28 fraction bits, as `limit`) at which a surface under highlights of this slope
/// (0...15) has the error that it has at `limit` under the brightest: `limit` times 1...6.3. The error of a
/// highlight is that of its cosine, which grows with the cube of the angle, times the slope.
[[nodiscard]] constexpr std::uint32_t limit_at_slope(std::uint32_t limit, std::uint8_t slope) {
  return (limit >> 4) * detail::kWiderAtSlope[slope];
}

}  // namespace arcspan
