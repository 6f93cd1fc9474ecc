// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// 8-bit luma, one byte per pixel. The smallest complete pixel format, to start others from.
struct Gray8 {
  using Encoded = std::uint8_t;
  using Word = std::uint8_t;
  using Cursor = WordCursor<std::uint8_t>;
  static constexpr unsigned kBitsPerPixel = 8;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return luma(c); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) {
    return luma(c);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return {encoded, encoded, encoded}; }
};

static_assert(PixelFormat<Gray8>);

}  // namespace arcspan
