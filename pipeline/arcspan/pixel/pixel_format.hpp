// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/dither.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A pixel format: how a colour becomes a pixel, and how the pixels of a row lie in memory. `Gray8`
/// (gray8.hpp) is the smallest; format_bases.hpp has what it shares with others, and formats of several
/// pixels per word.
///
///   Word                     the memory word: a row is an array of words_per_row(width) of them
///   Encoded                  the value of one pixel
///   kBitsPerPixel            bits of a pixel in memory
///   kDithers                 false; `Dithered<F>` makes it true
///   encode(c)                the pixel of an Rgb8, with the lower bits of its channels dropped
///   encode_dithered(c, x, y) the pixel of an Rgb8 at (x, y) of the picture, with ordered dither
///   decode(encoded)          the Rgb8 of a pixel, with encode(decode(p)) == p
///   Cursor(row, x)           points to pixel x of a row, 0 <= x < width
///
/// A Cursor writes and reads its pixel and steps one pixel to the right with next(). Where neighbours share a
/// Word, write() must keep their bits.
///
/// Optional, and used where present: encode() also of a PackedRgb, a ColourSegment or a FineRgb, which must
/// return encode(c.rgb8()) or encode(c.packed()) but can be faster; encode_dithered() of a PackedRgb,
/// likewise; word565(), as in Rgb565, of a format of 5-6-5 words; and, in a cursor of pixels that are whole
/// words, pixels(), the address of the present pixel, together with skip(count), which steps over `count`
/// pixels.
///
/// A new format is a header in this folder with a static_assert of this concept, and one entry in
/// pixel_format_list.hpp.
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

/// A level of `Bits` bits as 8 bits: its bits are repeated below it, so that 0 becomes 0 and the highest
/// level 255.
template <unsigned Bits>
[[nodiscard]] constexpr std::uint8_t expand_to_8(unsigned level) {
  static_assert(Bits >= 1 && Bits <= 8);
  unsigned bits = level << (8 - Bits);
  for (unsigned have = Bits; have < 8; have *= 2) bits |= bits >> have;
  return static_cast<std::uint8_t>(bits);
}

/// A format of words rrrrrggg gggbbbbb, perhaps with exchanged bytes. word565() is its own inverse.
template <class F>
concept Rgb565Words = requires(std::uint16_t v) {
  { F::word565(v) } -> std::same_as<std::uint16_t>;
  requires(F::encode(Rgb8{255, 132, 8}) == F::word565(0xFC21));  // all channels have their places
};

/// Whether operations take the colours of a format as 5-6-5 pixels, instead of PackedRgb.
template <class F>
inline constexpr bool kOperates565 = !F::kDithers && Rgb565Words<F>;

}  // namespace detail

/// The format `F` with ordered dither before the lower bits of a colour are dropped.
template <PixelFormat F>
struct Dithered : F {
  static constexpr bool kDithers = true;
};

/// The pixel of format `F` for colour `c` at (x, y) of the picture, dithered if F::kDithers.
template <PixelFormat F>
[[nodiscard]] constexpr typename F::Encoded encode_at(Rgb8 c, std::int32_t x, std::int32_t y) {
  if constexpr (F::kDithers) {
    return F::encode_dithered(c, x, y);
  } else {
    return F::encode(c);
  }
}
template <PixelFormat F>
[[nodiscard]] constexpr typename F::Encoded encode_at(PackedRgb c, std::int32_t x, std::int32_t y) {
  if constexpr (F::kDithers && requires { F::encode_dithered(c, x, y); }) {
    return F::encode_dithered(c, x, y);
  } else if constexpr (!F::kDithers && requires { F::encode(c); }) {
    return F::encode(c);
  } else {
    return encode_at<F>(c.rgb8(), x, y);
  }
}

/// encode_at() of a colour in another layout than PackedRgb.
template <PixelFormat F, PackableColour C>
[[nodiscard]] ARCSPAN_INLINE constexpr typename F::Encoded encode_at(const C& c, std::int32_t x,
                                                                     std::int32_t y) {
  if constexpr (!F::kDithers && requires { F::encode(c); }) {
    return F::encode(c);
  } else {
    return encode_at<F>(c.packed(), x, y);
  }
}

}  // namespace arcspan
