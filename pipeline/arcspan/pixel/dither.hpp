// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Thresholds of 8x8 ordered dither in 64ths of the quantisation step: row y mod 8, column x mod 8. Bayer's
/// matrix: each 4x4 part of it has all sixteen levels of a 4x4 matrix, evenly spaced.
inline constexpr std::uint8_t kDitherMatrix[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},    {48, 16, 56, 24, 50, 18, 58, 26}, {12, 44, 4, 36, 14, 46, 6, 38},
    {60, 28, 52, 20, 62, 30, 54, 22}, {3, 35, 11, 43, 1, 33, 9, 41},    {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37},   {63, 31, 55, 23, 61, 29, 53, 21}};

/// The threshold of pixel (x, y), 0...63.
[[nodiscard]] constexpr std::uint32_t dither_threshold(std::int32_t x, std::int32_t y) {
  return kDitherMatrix[static_cast<std::size_t>(y) & 7u][static_cast<std::size_t>(x) & 7u];
}

/// The x or y for dithering a pixel that is blended over one that is dithered already. With the same
/// thresholds all pixels of one code would round alike: black at half opacity over a mono grey would do
/// nothing. Rotating the lowest three bits makes the two thresholds of most pixels differ.
[[nodiscard]] constexpr std::int32_t dithered_again_at(std::int32_t at) {
  return ((at >> 1) & 3) | ((at & 1) << 2);
}

/// `level` (0...255) dithered for pixel (x, y), as a level of 0...255 of which the caller keeps the `Bits`
/// most significant bits and drops the rest. Over any aligned 8x8 pixels the mean of these codes is `level`,
/// within 1/100 of full scale; 0 and 255 are the lowest and the highest code everywhere. For `Bits` = 8 the
/// level is returned unchanged.
template <unsigned Bits>
[[nodiscard]] constexpr std::uint8_t dithered(std::uint8_t level, std::int32_t x, std::int32_t y) {
  static_assert(Bits >= 1 && Bits <= 8);
  if constexpr (Bits == 8) {
    return level;
  } else {
    // The levels 0...255 become 0...256 - 2^(8 - Bits), where the highest code begins, so that thresholds
    // below one step of the code neither lift it nor miss it.
    const std::uint32_t threshold = dither_threshold(x, y);
    if constexpr (Bits == 1) {  // a threshold has two steps of the sum
      return static_cast<std::uint8_t>((level + (std::uint32_t{level} >> 7) + 4 * threshold + 2) >> 1);
    } else {
      return static_cast<std::uint8_t>(level - (std::uint32_t{level} >> Bits) + (threshold >> (Bits - 2)));
    }
  }
}

}  // namespace arcspan
