// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/format_bases.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// 16 bits per pixel, rrrrrggggggbbbbb in a native word. Most colour panels take this format, big-endian on
/// the wire.
struct Rgb565 : WordPixels<std::uint16_t> {
  /// The word rrrrrggg gggbbbbb of a pixel, on which blending computes, and its own inverse.
  [[nodiscard]] static constexpr std::uint16_t word565(std::uint16_t v) { return v; }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) {
    return static_cast<Encoded>(((c.r & 0xF8u) << 8) | ((c.g & 0xFCu) << 3) | (c.b >> 3));
  }
  /// encode(c.rgb8()), directly from the packed channels.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode(PackedRgb c) {
    return static_cast<Encoded>(((c.lanes >> 5) & ~0x07E0u) | ((c.lanes >> 26) << 5));
  }
  /// encode(c.packed()), directly from the words, of a colour that knows how (FineRgb, LitTexel,
  /// ColourSegment).
  template <class C>
  requires requires(const C& c) {
    { c.rgb565() } -> std::same_as<std::uint16_t>;
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode(const C& c) { return c.rgb565(); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return encode(Rgb8{dithered<5>(c.r, x, y), dithered<6>(c.g, x, y), dithered<5>(c.b, x, y)});
  }
  /// encode_dithered(c.rgb8(), x, y), with all channels in one word. No channel carries.
  [[nodiscard]] static constexpr Encoded encode_dithered(PackedRgb c, std::int32_t x, std::int32_t y) {
    const std::uint32_t threshold = dither_threshold(x, y);
    const std::uint32_t taken = ((c.lanes >> 5) & 0xE01Cu) + (c.lanes >> 30 << 24);
    const std::uint32_t added = ((threshold >> 3) * 0x2004u) + (threshold >> 4 << 24);
    return encode(PackedRgb{c.lanes - taken + added});
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr Rgb8 decode(Encoded encoded) {
    return {detail::expand_to_8<5>(static_cast<unsigned>(encoded >> 11)),
            detail::expand_to_8<6>(static_cast<unsigned>(encoded >> 5) & 63u),
            detail::expand_to_8<5>(static_cast<unsigned>(encoded) & 31u)};
  }
};

static_assert(PixelFormat<Rgb565>);

}  // namespace arcspan
