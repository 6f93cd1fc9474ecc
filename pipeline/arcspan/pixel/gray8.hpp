// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

#include <cstdint>

namespace arcspan {

/// 8-bit luma, one byte per pixel. The smallest pixel format, to start others from.
struct Gray8 : WordPixels<std::uint8_t> {
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return luma(c); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) {
    return luma(c);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return {encoded, encoded, encoded}; }
};

static_assert(PixelFormat<Gray8>);

}  // namespace arcspan
