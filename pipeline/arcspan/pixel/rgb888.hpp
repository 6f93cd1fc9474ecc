// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

#include <cstdint>

namespace arcspan {

/// 24 bits per pixel: three bytes r, g, b.
struct Rgb888 : WordPixels<Rgb8> {
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return c; }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return c; }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return encoded; }
};

static_assert(PixelFormat<Rgb888>);

}  // namespace arcspan
