// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace arcspan {

/// A bound of the highlights over a triangle, among others of the slopes of c^n, summed over the lights by
/// their weights.
struct HighlightBound {
  std::int32_t nearest;  ///< a lower bound of their half distances (PowerTable); INT32_MAX if there is none
  /// An upper bound of the sum in sixteenths of its largest value, rounded down: 0...kBrightest.
  std::uint8_t strength;
  /// The same in sixteenths of the largest value of one light with the weight 1: 0...kBrightest.
  std::uint8_t slope;

  static constexpr std::uint8_t kBrightest = 15;
};

/// Returns the squared chord up to which a surface is as accurate under highlights of this strength (or
/// slope) as it is up to `limit` where they are brightest: at most 6.3 times as much. The error of a
/// highlight is that of its cosine, which grows with the cube of the angle, times the slope.
[[nodiscard]] constexpr std::uint32_t limit_at_strength(std::uint32_t limit, std::uint8_t strength) {
  // Entry i is (16 / (i + 1))^(2/3) with 4 fraction bits, rounded down.
  constexpr std::array<std::uint8_t, 16> kWider{101, 64, 48, 40, 34, 30, 27, 25,
                                                23,  21, 20, 19, 18, 17, 16, 16};
  return (limit >> 4) * kWider[strength];
}

}  // namespace arcspan
