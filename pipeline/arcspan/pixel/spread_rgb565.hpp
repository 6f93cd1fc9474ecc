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
[[nodiscard]] constexpr std::uint32_t saturated_sum(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t kRedBlueCarries = 0x00010020;
  constexpr std::uint32_t kGreenCarry = 0x08000000;
  const std::uint32_t sum = a + b;
  const std::uint32_t red_blue = sum & kRedBlueCarries;
  const std::uint32_t green = sum & kGreenCarry;
  return (sum | (red_blue - (red_blue >> 5)) | (green - (green >> 6))) & kSpreadMask;
}
/// A PackedRgb without half step as a spread pixel, rounded.
[[nodiscard]] constexpr std::uint32_t spread(PackedRgb c) {
  const auto five = [](std::uint32_t v) { return v > 1007 ? 31u : (v + 16) >> 5; };
  const std::uint32_t green = c.lanes >> 22;
  return ((green > 1015 ? 63u : (green + 8) >> 4) << 21) | (five((c.lanes >> 11) & 1023u) << 11) |
         five(c.lanes & 1023u);
}
/// spread * factor, rounded; factor is 0...32 and stands for 0...1.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t scaled_spread(std::uint32_t spread,
                                                                   std::uint32_t factor) {
  constexpr std::uint32_t kHalf = 0x02008010;
  return ((spread * factor + kHalf) >> 5) & kSpreadMask;
}
/// a + (b - a) * factor, rounded; factor is 0...32.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t mixed_spread(std::uint32_t a, std::uint32_t b,
                                                                  std::uint32_t factor) {
  constexpr std::uint32_t kHalf = 0x02008010;
  return ((a * (32 - factor) + b * factor + kHalf) >> 5) & kSpreadMask;
}

}  // namespace arcspan::detail
