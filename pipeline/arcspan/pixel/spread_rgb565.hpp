// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
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
/// The sum of two spread pixels, saturated; `Wide` if they are a wide_spread().
template <bool Wide = false>
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t saturated_sum(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t kRedBlueCarries = 0x00010020;
  constexpr std::uint32_t kGreenCarry = Wide ? 0x10000000 : 0x08000000;  // the bit above green
  std::uint32_t sum = a + b;
  if ((sum & (kRedBlueCarries | kGreenCarry)) != 0) [[unlikely]] {
    const std::uint32_t red_blue = sum & kRedBlueCarries;
    const std::uint32_t green = sum & kGreenCarry;
    sum = (sum | (red_blue - (red_blue >> 5)) | (green - (green >> 6))) & ~(kRedBlueCarries | kGreenCarry);
  }
  return sum;
}
/// A PackedRgb without half step as a spread pixel, rounded.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t spread(PackedRgb c) {
  // 31/32 of red and blue and 63/64 of green, plus half a step of the result, do not overflow.
  constexpr std::uint32_t kHalves = (std::uint32_t{8} << 22) | (std::uint32_t{16} << 11) | 16;
  const std::uint32_t red_blue = (c.lanes >> 5) & 0x0000F81F;
  const std::uint32_t green = (c.lanes >> 28) << 22;
  return ((c.lanes - red_blue - green + kHalves) >> 5) & kSpreadMask;
}
/// Half a step of each channel that has five fraction bits.
inline constexpr std::uint32_t kSpreadHalf = 0x02008010;
/// spread * factor, rounded; factor is 0...32 and stands for 0...1.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t scaled_spread(std::uint32_t spread,
                                                                   std::uint32_t factor) {
  return ((spread * factor + kSpreadHalf) >> 5) & kSpreadMask;
}
/// (a * rest + b * factor) / 32, rounded; rest + factor = 32.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t mixed_spread(std::uint32_t a, std::uint32_t rest,
                                                                  std::uint32_t b, std::uint32_t factor) {
  return ((a * rest + (b * factor + kSpreadHalf)) >> 5) & kSpreadMask;
}
/// a + (b - a) * factor, rounded; factor is 0...32.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t mixed_spread(std::uint32_t a, std::uint32_t b,
                                                                  std::uint32_t factor) {
  // Borrows of the difference cancel out in the sum.
  return (((b - a) * factor + ((a << 5) + kSpreadHalf)) >> 5) & kSpreadMask;
}

// ---- Light

/// Light has levels of 0...64, as many as the green of a 5-6-5 pixel. A product with it takes a wider spread:
/// g in bits 27...22, r in 15...11, b in 4...0, so that each channel has six bits of room below it.
inline constexpr std::uint32_t kWideMask = 0x0FC0F81F;
[[nodiscard]] constexpr std::uint32_t wide_spread(std::uint32_t rgb565) {
  return (rgb565 | (rgb565 << 17)) & kWideMask;
}
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t joined_wide(std::uint32_t spread) {
  return static_cast<std::uint16_t>(spread | (spread >> 17));
}
/// A level of light as products take it.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t light_factor(std::uint32_t level) { return level << 25; }

/// A wide_spread() times the level of a light_factor(), rounded. The pixel and `mask` are given times 16, so
/// that three bits are left of the fraction of blue.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t lit_spread(std::uint32_t pixel, std::uint32_t factor,
                                                                std::uint32_t mask = kWideMask << 4) {
  if constexpr (kHasLongMultiply) {
    std::uint32_t half = 0x01002004;
    hide_value(half);
    return (((multiply_high(pixel, factor) + half) << 1) & mask) >> 4;
  } else {
    const std::uint32_t level = factor >> 25;
    const std::uint32_t red_blue = ((pixel >> 4) & 0xF81F) * level + 0x00010020;
    const std::uint32_t green = (pixel >> 26) * level + 32;
    return ((red_blue >> 6) & 0xF81F) | (green >> 6 << 22);
  }
}
/// lit_spread() of a 5-6-5 pixel.
[[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t lit_pixel(std::uint32_t rgb565, std::uint32_t factor) {
  std::uint32_t mask = kWideMask << 4;
  hide_value(mask);  // otherwise compilers spend three instructions on one of its two uses
  return lit_spread(((rgb565 | (rgb565 << 17)) << 4) & mask, factor, mask);
}

}  // namespace arcspan::detail
