// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Offsets of 4x4 ordered dither in eighths of the quantisation step, as fixed-function consoles use them:
/// row y mod 4, column x mod 4. For a channel of 5 bits they are in 8-bit steps.
inline constexpr std::int8_t kDitherMatrix[4][4] = {
    {-4, 0, -3, 1}, {2, -2, 3, -1}, {-3, 1, -4, 0}, {3, -1, 2, -2}};

/// `level` (0...255) plus the dither offset of pixel (x, y), saturated to 0...255. The caller truncates the
/// result to its `Bits` most significant bits. The quantisation step is 2^(8 - Bits); for `Bits` = 8 the
/// level is returned unchanged.
template <unsigned Bits>
[[nodiscard]] constexpr std::uint8_t dithered(std::uint8_t level, std::int32_t x, std::int32_t y) {
  static_assert(Bits >= 1 && Bits <= 8);
  if constexpr (Bits == 8) {
    return level;
  } else {
    const std::int32_t base =
        kDitherMatrix[static_cast<std::size_t>(y) & 3u][static_cast<std::size_t>(x) & 3u];
    const std::int32_t offset = base * (1 << (8 - Bits)) >> 3;
    const std::int32_t sum = level + offset;
    return static_cast<std::uint8_t>(sum < 0 ? 0 : sum > 255 ? 255 : sum);
  }
}

}  // namespace arcspan
