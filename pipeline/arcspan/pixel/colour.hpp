// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan {

/// A colour as the span stage produces it: three 8-bit channels, 0 dark to 255 full.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// Luma of `c`, 0...255: the BT.601 weights 0.299, 0.587, 0.114 in eighths of a byte (77, 150, 29 of 256),
/// rounded. A neutral grey keeps its value exactly, since the weights sum to 256.
[[nodiscard]] constexpr std::uint8_t luma(Rgb8 c) {
  return static_cast<std::uint8_t>((77u * c.r + 150u * c.g + 29u * c.b + 128u) >> 8);
}

}  // namespace arcspan
