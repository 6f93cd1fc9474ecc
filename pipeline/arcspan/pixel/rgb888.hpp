// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// 24 bits per pixel: three bytes r, g, b.
struct Rgb888 {
  using Encoded = Rgb8;
  using Word = Rgb8;
  using Cursor = WordCursor<Rgb8>;
  static constexpr unsigned kBitsPerPixel = 24;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return c; }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return c; }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return encoded; }
};

static_assert(PixelFormat<Rgb888>);

}  // namespace arcspan
