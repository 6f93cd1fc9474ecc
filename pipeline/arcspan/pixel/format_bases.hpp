// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

/// What pixel formats have in common.
namespace arcspan {

/// The base of formats whose pixels are one word each.
template <class Pixel>
struct WordPixels {
  using Encoded = Pixel;
  using Word = Pixel;
  using Cursor = WordCursor<Pixel>;
  static constexpr unsigned kBitsPerPixel = 8 * sizeof(Pixel);
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
};

/// The base of formats of `Bits` = 1, 2 or 4 bits of luma, the leftmost pixel of a byte in its highest bits.
template <unsigned Bits>
struct LumaBits {
  using Encoded = std::uint8_t;
  using Word = std::uint8_t;
  using Cursor = BitCursor<Bits>;
  static constexpr unsigned kBitsPerPixel = Bits;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    constexpr std::size_t kPerByte = 8 / Bits;
    return (static_cast<std::size_t>(width) + kPerByte - 1) / kPerByte;
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) {
    return static_cast<Encoded>(luma(c) >> (8 - Bits));
  }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Encoded>(dithered<Bits>(luma(c), x, y) >> (8 - Bits));
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    const std::uint8_t v = detail::expand_to_8<Bits>(encoded);
    return {v, v, v};
  }
};

}  // namespace arcspan
