// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/dither.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A pixel format: how one pixel is encoded and how a row of them lies in memory.
///
/// `Code` is one pixel's value by itself; `Word` is the memory word that rows are arrays of. A `Cursor`
/// stands on a pixel of a row and moves to the right: `write` stores a code there, `read` gives it back,
/// `next` steps. Formats of less than 8 bits share a Word between neighbours, so a cursor reads, modifies and
/// writes it.
template <class F>
concept PixelFormat = requires(Rgb8 c, std::int32_t x, typename F::Encoded encoded, typename F::Word* row,
                               typename F::Cursor cursor) {
  { F::kBitsPerPixel } -> std::convertible_to<unsigned>;
  { F::kDithers } -> std::convertible_to<bool>;
  { F::words_per_row(x) } -> std::same_as<std::size_t>;
  { F::encode(c) } -> std::same_as<typename F::Encoded>;
  { F::encode_dithered(c, x, x) } -> std::same_as<typename F::Encoded>;
  { F::decode(encoded) } -> std::same_as<Rgb8>;
  {typename F::Cursor(row, x)};
  {cursor.write(encoded)};
  { cursor.read() } -> std::same_as<typename F::Encoded>;
  {cursor.next()};
};

namespace detail {

/// Repeats the top bits of a `Bits`-bit level into the low bits of a byte: 0 stays 0 and full becomes 255.
template <unsigned Bits>
[[nodiscard]] constexpr std::uint8_t expand_to_8(unsigned level) {
  static_assert(Bits == 1 || (Bits >= 4 && Bits <= 8));
  if constexpr (Bits == 1) {
    return level != 0 ? 255 : 0;
  } else {
    return static_cast<std::uint8_t>((level << (8 - Bits)) | (level >> (2 * Bits - 8)));
  }
}

}  // namespace detail

/// The format `F` with ordered dither before truncation.
template <PixelFormat F>
struct Dithered : F {
  static constexpr bool kDithers = true;
};

/// The code that format `F` stores for colour `c` at pixel (x, y) of the picture.
template <PixelFormat F>
[[nodiscard]] constexpr typename F::Encoded encode_at(PackedRgb c, std::int32_t x, std::int32_t y) {
  if constexpr (F::kDithers) {
    return F::encode_dithered(c.rgb8(), x, y);
  } else if constexpr (requires { F::encode(c); }) {
    return F::encode(c);
  } else {
    return F::encode(c.rgb8());
  }
}

/// The same for a colour whose lanes are laid out otherwise.
template <PixelFormat F, PackableColour C>
[[nodiscard]] constexpr typename F::Encoded encode_at(const C& c, std::int32_t x, std::int32_t y) {
  if constexpr (!F::kDithers && requires { F::encode(c); }) {
    return F::encode(c);
  } else {
    return encode_at<F>(c.packed(), x, y);
  }
}

}  // namespace arcspan
