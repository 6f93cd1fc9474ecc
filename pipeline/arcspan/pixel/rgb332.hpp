// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>

#include <cstdint>

namespace arcspan {

/// 8 bits per pixel, rrrgggbb in a byte.
struct Rgb332 : WordPixels<std::uint8_t> {
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) {
    return static_cast<Encoded>((c.r & 0xE0u) | ((c.g & 0xE0u) >> 3) | (c.b >> 6));
  }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return encode(Rgb8{dithered<3>(c.r, x, y), dithered<3>(c.g, x, y), dithered<2>(c.b, x, y)});
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    return {detail::expand_to_8<3>(static_cast<unsigned>(encoded >> 5)),
            detail::expand_to_8<3>(static_cast<unsigned>(encoded >> 2) & 7u),
            detail::expand_to_8<2>(static_cast<unsigned>(encoded) & 3u)};
  }
};

static_assert(PixelFormat<Rgb332>);

}  // namespace arcspan
