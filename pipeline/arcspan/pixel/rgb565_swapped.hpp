// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Rgb565 with its two bytes exchanged. On a little-endian processor the memory then has the bytes that a
/// panel of 16-bit colours takes: whole rows of a frame are sent as they are by hal::Panel::start_write().
/// LVGL calls it RGB565_SWAPPED.
struct Rgb565Swapped : WordPixels<std::uint16_t> {
  /// The word of a pixel in Rgb565, and its own inverse.
  [[nodiscard]] static constexpr std::uint16_t word565(std::uint16_t v) {
    return static_cast<std::uint16_t>((v << 8) | (v >> 8));
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) { return word565(Rgb565::encode(c)); }
  template <class C>
  requires requires(const C& c) { Rgb565::encode(c); }
  [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode(const C& c) {
    return word565(Rgb565::encode(c));
  }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return word565(Rgb565::encode_dithered(c, x, y));
  }
  [[nodiscard]] static constexpr Encoded encode_dithered(PackedRgb c, std::int32_t x, std::int32_t y) {
    return word565(Rgb565::encode_dithered(c, x, y));
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) { return Rgb565::decode(word565(encoded)); }
};

static_assert(PixelFormat<Rgb565Swapped>);

}  // namespace arcspan
