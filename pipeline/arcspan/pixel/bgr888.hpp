// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

#include <cstdint>

namespace arcspan {

/// A colour whose bytes are blue, green, red in memory.
struct Bgr8 {
  std::uint8_t b = 0;
  std::uint8_t g = 0;
  std::uint8_t r = 0;

  friend constexpr bool operator==(const Bgr8&, const Bgr8&) = default;
};

/// 24 bits per pixel: three bytes b, g, r, as in Windows bitmaps, in DRM's RGB888 and in LVGL's.
struct Bgr888 : WordPixels<Bgr8> {
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return {c.b, c.g, c.r}; }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) {
    return encode(c);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return {encoded.r, encoded.g, encoded.b}; }
};

static_assert(PixelFormat<Bgr888>);

}  // namespace arcspan
