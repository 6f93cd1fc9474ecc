// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/pixel/cursor.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// 16 bits per pixel, rrrrrggggggbbbbb in a native word. Most colour panels take this format, big-endian on
/// the wire.
struct Rgb565 {
  using Encoded = std::uint16_t;
  using Word = std::uint16_t;
  using Cursor = WordCursor<std::uint16_t>;
  static constexpr unsigned kBitsPerPixel = 16;
  static constexpr bool kDithers = false;
  static constexpr bool kIsRgb565 = true;  ///< a pixel is a 5-6-5 word, on which blending may compute

  [[nodiscard]] static constexpr std::size_t words_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Encoded encode(Rgb8 c) {
    return static_cast<Encoded>(((c.r & 0xF8u) << 8) | ((c.g & 0xFCu) << 3) | (c.b >> 3));
  }
  /// encode(c.rgb8()), directly from the packed channels.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode(PackedRgb c) {
    if constexpr (kHasWideRegisters || !kHasManyRegisters) {
      const std::uint32_t levels = c.lanes & 0xFC1F03E0u;  // the first shift leaves green above bit 15
      return static_cast<Encoded>((levels >> 5) | (levels >> 21));
    }
    // For processors where a shift is part of another instruction, but such a mask is not.
    return static_cast<Encoded>(((c.lanes >> 5) & ~0x07E0u) | ((c.lanes >> 26) << 5));
  }
#if ARCSPAN_HAS_BIT_INSERT
  /// encode(c) for colours that differ from pixel to pixel: by the bit-field insert instruction, which gcc
  /// does not move out of a loop over pixels of one colour.
  [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode_varying(PackedRgb c) {
    // A bit-field, because gcc makes a bit-field insert (BFI) of an assignment to one, not of shifts and
    // masks.
    struct Bits {
      std::uint32_t blue : 5;
      std::uint32_t green : 6;
      std::uint32_t above : 21;
    };
    auto bits = std::bit_cast<Bits>(c.lanes >> 5);
    const std::uint32_t green = c.lanes >> 26;
    bits.green = green & 63u;
    return static_cast<Encoded>(std::bit_cast<std::uint32_t>(bits));
  }
#else
  /// encode(c) for colours that differ from pixel to pixel: one product does both shifts.
  template <std::same_as<PackedRgb> C>
  requires kHasWideRegisters [[nodiscard]] ARCSPAN_INLINE static constexpr Encoded encode_varying(C c) {
    std::uint64_t both = 0x10001;
    hide_value(both);  // otherwise compilers shift and add
    return static_cast<Encoded>(((c.lanes & 0xFC1F03E0u) * both) >> 21);
  }
#endif
  /// encode(c.packed()), directly from the words.
  [[nodiscard]] static constexpr Encoded encode(ColourSegment c) {
    const std::uint32_t levels = c.red_blue & 0x7C007C00u;  // one shift per channel; the other one falls out
    return static_cast<Encoded>((levels >> 15) | (levels >> 10) | ((c.green >> 25) << 5));
  }
  /// encode(c.packed()), directly from the words, of a colour that knows how (BasicFineRgb, LitTexel).
  template <class C>
  requires requires(const C& c) {
    { c.rgb565() } -> std::same_as<std::uint16_t>;
  }
  [[nodiscard]] static constexpr Encoded encode(const C& c) { return c.rgb565(); }
  [[nodiscard]] static constexpr Encoded encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return encode(Rgb8{dithered<5>(c.r, x, y), dithered<6>(c.g, x, y), dithered<5>(c.b, x, y)});
  }
  [[nodiscard]] static constexpr Rgb8 decode(Encoded encoded) {
    return {detail::expand_to_8<5>(static_cast<unsigned>(encoded >> 11)),
            detail::expand_to_8<6>(static_cast<unsigned>(encoded >> 5) & 63u),
            detail::expand_to_8<5>(static_cast<unsigned>(encoded) & 31u)};
  }
};

static_assert(PixelFormat<Rgb565>);

}  // namespace arcspan
