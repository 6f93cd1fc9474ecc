// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

#include <cstdint>

namespace arcspan {

/// 32 bits per pixel, 0xUURRGGBB in a native word, where U is `Upper`.
template <std::uint8_t Upper>
struct Rgb32 : WordPixels<std::uint32_t> {
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) {
    return (std::uint32_t{Upper} << 24) | (std::uint32_t{c.r} << 16) | (std::uint32_t{c.g} << 8) | c.b;
  }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t, std::int32_t) {
    return encode(c);
  }
  /// The upper byte is ignored.
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    return {static_cast<std::uint8_t>(encoded >> 16), static_cast<std::uint8_t>(encoded >> 8),
            static_cast<std::uint8_t>(encoded)};
  }
};

/// 32 bits per pixel, 0x00RRGGBB in a native word: DRM's XRGB8888.
struct Xrgb8888 : Rgb32<0> {};

static_assert(PixelFormat<Xrgb8888>);

}  // namespace arcspan
