// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A texel's colour in 16 bits, in three ways: 5-6-5 without alpha, or fewer bits for colours and 1 or 4 bits
/// of alpha, which begin at bit kAlphaShift. rgb565() returns the colour as a 5-6-5 pixel (rrrrrggggggbbbbb),
/// alpha() the opacity in 16ths, 0...16.
struct OpaqueColour {
  static constexpr unsigned kAlphaBits = 0;
  static constexpr unsigned kAlphaShift = 0;
  [[nodiscard]] static constexpr std::uint16_t rgb565(std::uint16_t stored) { return stored; }
  [[nodiscard]] static constexpr std::uint32_t alpha(std::uint16_t) { return 16; }
};

/// rrrrrgggggabbbbb: a 5-6-5 pixel whose lowest bit of green is the opacity.
struct Alpha1Colour {
  static constexpr unsigned kAlphaBits = 1;
  static constexpr unsigned kAlphaShift = 5;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint16_t rgb565(std::uint16_t stored) {
    // The sixth bit of green repeats its highest one, where the texel is opaque; elsewhere it is 0.
    return static_cast<std::uint16_t>(stored & ((std::uint32_t{stored} >> 5) | 0xFFDFu));
  }
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint32_t alpha(std::uint16_t stored) {
    return (stored & 0x20u) != 0 ? 16 : 0;
  }
};

/// rrrrggggbbbbaaaa
struct Alpha4Colour {
  static constexpr unsigned kAlphaBits = 4;
  static constexpr unsigned kAlphaShift = 0;
  [[nodiscard]] static constexpr std::uint16_t rgb565(std::uint16_t stored) {
    const std::uint32_t s = stored;
    return static_cast<std::uint16_t>((s & 0xF000u) | ((s >> 4) & 0x0800u) | ((s & 0x0F00u) >> 1) |
                                      ((s >> 5) & 0x0060u) | ((s & 0x00F0u) >> 3) | ((s >> 7) & 1u));
  }
  [[nodiscard]] static constexpr std::uint32_t alpha(std::uint16_t stored) {
    const std::uint32_t a = stored & 15u;
    return a + (a >> 3);
  }
};

template <class C>
concept TexelColour = requires(std::uint16_t stored) {
  { C::kAlphaBits } -> std::convertible_to<unsigned>;
  { C::rgb565(stored) } -> std::same_as<std::uint16_t>;
  { C::alpha(stored) } -> std::same_as<std::uint32_t>;
};

/// A format of texels: how they lie in memory. `Word` is the memory word and kBits the bits of a texel;
/// kPaletteSize is the number of a palette's colours, 0 without one. `stored` returns texel `index` of a
/// level as its ColourFormat stores it.
template <TexelColour C = OpaqueColour>
struct DirectTexels {
  using ColourFormat = C;
  using Word = std::uint16_t;
  static constexpr unsigned kBits = 16;
  static constexpr std::size_t kPaletteSize = 0;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint16_t stored(const Word* words, const std::uint16_t*,
                                                                     std::uint32_t index) {
    return words[index];
  }
};

/// 8 bits per texel, the index of a colour in a palette.
template <TexelColour C = OpaqueColour>
struct Palette8Texels {
  using ColourFormat = C;
  using Word = std::uint8_t;
  static constexpr unsigned kBits = 8;
  static constexpr std::size_t kPaletteSize = 256;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint16_t stored(const Word* words,
                                                                     const std::uint16_t* palette,
                                                                     std::uint32_t index) {
    return palette[words[index]];
  }
};

/// 4 bits per texel, the left one of two in the upper bits.
template <TexelColour C = OpaqueColour>
struct Palette4Texels {
  using ColourFormat = C;
  using Word = std::uint8_t;
  static constexpr unsigned kBits = 4;
  static constexpr std::size_t kPaletteSize = 16;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint16_t stored(const Word* words,
                                                                     const std::uint16_t* palette,
                                                                     std::uint32_t index) {
    return palette[(static_cast<std::uint32_t>(words[index >> 1]) >> ((~index & 1u) << 2)) & 15u];
  }
};

/// 8 bits per texel, a grey level.
struct GrayTexels {
  using ColourFormat = OpaqueColour;
  using Word = std::uint8_t;
  static constexpr unsigned kBits = 8;
  static constexpr std::size_t kPaletteSize = 0;
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint16_t stored(const Word* words, const std::uint16_t*,
                                                                     std::uint32_t index) {
    const std::uint32_t level = words[index];
    return static_cast<std::uint16_t>(((level >> 3) * 0x0801u) | ((level >> 2) << 5));
  }
};

template <class T>
concept TexelFormat = TexelColour<typename T::ColourFormat> &&
    requires(const typename T::Word* words, const std::uint16_t* palette, std::uint32_t index) {
  { T::kBits } -> std::convertible_to<unsigned>;
  { T::kPaletteSize } -> std::convertible_to<std::size_t>;
  { T::ColourFormat::rgb565(T::stored(words, palette, index)) } -> std::same_as<std::uint16_t>;
};

static_assert(TexelFormat<DirectTexels<>> && TexelFormat<Palette8Texels<>> && TexelFormat<Palette4Texels<>>);
static_assert(TexelFormat<GrayTexels>);

}  // namespace arcspan
