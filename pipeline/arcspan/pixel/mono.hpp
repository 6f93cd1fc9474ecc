// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// One bit per pixel, set if the luma is at least 128; eight pixels per byte, the leftmost in the highest
/// bit.
struct Mono {
  using Encoded = std::uint8_t;
  using Word = std::uint8_t;
  using Cursor = BitCursor<1>;
  static constexpr unsigned kBitsPerPixel = 1;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return (static_cast<std::size_t>(width) + 7) / 8;
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return static_cast<Encoded>(luma(c) >> 7); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Encoded>(dithered<1>(luma(c), x, y) >> 7);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    const std::uint8_t v = detail::expand_to_8<1>(encoded);
    return {v, v, v};
  }
};

static_assert(PixelFormat<Mono>);

}  // namespace arcspan
