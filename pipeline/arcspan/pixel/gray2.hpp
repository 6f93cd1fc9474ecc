// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// 2-bit luma, four pixels per byte, the leftmost in the highest bits.
struct Gray2 {
  using Encoded = std::uint8_t;
  using Word = std::uint8_t;
  using Cursor = BitCursor<2>;
  static constexpr unsigned kBitsPerPixel = 2;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return (static_cast<std::size_t>(width) + 3) / 4;
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return static_cast<Encoded>(luma(c) >> 6); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Encoded>(dithered<2>(luma(c), x, y) >> 6);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    const std::uint8_t v = detail::expand_to_8<2>(encoded);
    return {v, v, v};
  }
};

static_assert(PixelFormat<Gray2>);

}  // namespace arcspan
