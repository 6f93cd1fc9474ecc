// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// 4-bit luma, two pixels per byte, the left one in the upper four bits.
struct Gray4 {
  using Encoded = std::uint8_t;
  using Word = std::uint8_t;
  using Cursor = BitCursor<4>;
  static constexpr unsigned kBitsPerPixel = 4;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return (static_cast<std::size_t>(width) + 1) / 2;
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return static_cast<Encoded>(luma(c) >> 4); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Encoded>(dithered<4>(luma(c), x, y) >> 4);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    const std::uint8_t v = detail::expand_to_8<4>(encoded);
    return {v, v, v};
  }
};

static_assert(PixelFormat<Gray4>);

}  // namespace arcspan
