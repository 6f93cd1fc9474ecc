// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Arithmetic with all channels of a 5-6-5 pixel in one word.
namespace arcspan::detail {

/// A 5-6-5 pixel spread over a word: g in bits 26...21, r in 15...11, b in 4...0. Each channel then has five
/// fraction bits below it, or a bit for a carry above it.
inline constexpr std::uint32_t kSpreadMask = 0x07E0F81F;
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t spread(std::uint32_t rgb565) {
  return (rgb565 | (rgb565 << 16)) & kSpreadMask;
}
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t joined(std::uint32_t spread) {
  return static_cast<std::uint16_t>(spread | (spread >> 16));
}
/// The sum of two spread pixels, saturated.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t saturated_sum(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t kRedBlueCarries = 0x00010020;
  constexpr std::uint32_t kGreenCarry = 0x08000000;
  const std::uint32_t sum = a + b;
  const std::uint32_t red_blue = sum & kRedBlueCarries;
  const std::uint32_t green = sum & kGreenCarry;
  return (sum | (red_blue - (red_blue >> 5)) | (green - (green >> 6))) & kSpreadMask;
}
/// A PackedRgb without half step as a spread pixel, rounded.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t spread(PackedRgb c) {
  // 31/32 of red and blue and 63/64 of green, plus half a step of the result, do not overflow.
  constexpr std::uint32_t kHalves = (std::uint32_t{8} << 22) | (std::uint32_t{16} << 11) | 16;
  const std::uint32_t red_blue = (c.lanes >> 5) & 0x0000F81F;
  const std::uint32_t green = (c.lanes >> 28) << 22;
  return ((c.lanes - red_blue - green + kHalves) >> 5) & kSpreadMask;
}
/// spread * factor, rounded; factor is 0...32 and stands for 0...1.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t scaled_spread(std::uint32_t spread, std::uint32_t factor,
                                                                   std::uint32_t mask = kSpreadMask) {
  constexpr std::uint32_t kHalf = 0x02008010;
  return ((spread * factor + kHalf) >> 5) & mask;
}
/// scaled_spread() of a 5-6-5 pixel.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t scaled_pixel(std::uint32_t rgb565,
                                                                  std::uint32_t factor) {
  std::uint32_t mask = kSpreadMask;
  hide_value(mask);  // otherwise compilers spend three instructions on one of its two uses
  return scaled_spread((rgb565 * 0x10001u) & mask, factor, mask);
}
/// a + (b - a) * factor, rounded; factor is 0...32.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t mixed_spread(std::uint32_t a, std::uint32_t b,
                                                                  std::uint32_t factor) {
  constexpr std::uint32_t kHalf = 0x02008010;
  return ((a * (32 - factor) + b * factor + kHalf) >> 5) & kSpreadMask;
}

}  // namespace arcspan::detail
