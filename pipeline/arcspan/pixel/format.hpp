// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/keep.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/colour_segment.hpp>
#include <arcspan/pixel/dither.hpp>
#include <arcspan/pixel/fine_rgb.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A pixel format: how one pixel is encoded and how a row of them lies in memory.
///
/// `Code` is one pixel's value by itself; `Unit` is the memory word that rows are arrays of. A `Cursor`
/// stands on a pixel of a row and moves to the right: `write` stores a code there, `read` gives it back,
/// `next` steps. Formats of less than 8 bits share a Unit between neighbours, so a cursor reads, modifies and
/// writes it.
template <class F>
concept PixelFormat = requires(Rgb8 c, std::int32_t x, typename F::Code code, typename F::Unit* row,
                               typename F::Cursor cursor) {
  { F::kBitsPerPixel } -> std::convertible_to<unsigned>;
  { F::kDithers } -> std::convertible_to<bool>;
  { F::units_per_row(x) } -> std::same_as<std::size_t>;
  { F::encode(c) } -> std::same_as<typename F::Code>;
  { F::encode_dithered(c, x, x) } -> std::same_as<typename F::Code>;
  { F::decode(code) } -> std::same_as<Rgb8>;
  {typename F::Cursor(row, x)};
  {cursor.write(code)};
  { cursor.read() } -> std::same_as<typename F::Code>;
  {cursor.next()};
};

namespace detail {

/// Cursor of a format whose pixels are whole Units.
template <class Code>
class WordCursor {
 public:
  constexpr WordCursor(Code* row, std::int32_t x) : at_(row + x) {}
  constexpr void write(Code code) { *at_ = code; }
  [[nodiscard]] constexpr Code read() const { return *at_; }
  constexpr void next() { ++at_; }
  constexpr void skip(std::int32_t count) { at_ += count; }
  /// The present pixel and those to its right.
  [[nodiscard]] constexpr Code* codes() const { return at_; }

 private:
  Code* at_;
};

/// Cursor of a format with `Bits` = 1, 2 or 4 bits per pixel; the leftmost pixel is in the highest bits.
template <unsigned Bits>
class BitCursor {
 public:
  constexpr BitCursor(std::uint8_t* row, std::int32_t x)
      : at_(row + (x >> kLog2PerByte)), shift_(kTop - Bits * (static_cast<unsigned>(x) & kMaskPerByte)) {}
  constexpr void write(std::uint8_t code) {
    const unsigned kept = *at_ & ~(kCodeMask << shift_);
    *at_ = static_cast<std::uint8_t>(kept | (static_cast<unsigned>(code) << shift_));
  }
  [[nodiscard]] constexpr std::uint8_t read() const {
    return static_cast<std::uint8_t>((*at_ >> shift_) & kCodeMask);
  }
  constexpr void next() {
    if (shift_ == 0) {
      ++at_;
      shift_ = kTop;
    } else {
      shift_ -= Bits;
    }
  }

 private:
  static constexpr unsigned kLog2PerByte = Bits == 1 ? 3 : Bits == 2 ? 2 : 1;
  static constexpr unsigned kMaskPerByte = (1u << kLog2PerByte) - 1;
  static constexpr unsigned kTop = 8 - Bits;
  static constexpr unsigned kCodeMask = (1u << Bits) - 1;

  std::uint8_t* at_;
  unsigned shift_;
};

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

/// 16 bits, rrrrrggggggbbbbb in a native word; what most colour panels take (big-endian on the wire).
struct Rgb565 {
  using Code = std::uint16_t;
  using Unit = std::uint16_t;
  using Cursor = detail::WordCursor<std::uint16_t>;
  static constexpr unsigned kBitsPerPixel = 16;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t units_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Code encode(Rgb8 c) {
    return static_cast<Code>(((c.r & 0xF8u) << 8) | ((c.g & 0xFCu) << 3) | (c.b >> 3));
  }
  /// encode(c.rgb8()), straight from the lanes.
  [[nodiscard]] static constexpr Code encode(PackedRgb c) {
    if constexpr (kWideRegisters || !kManyRegisters) {
      const std::uint32_t levels = c.lanes & 0xFC1F03E0u;  // green in the first leaves the code
      return static_cast<Code>((levels >> 5) | (levels >> 21));
    }
    // Where shifts are free within other instructions, and such masks are not.
    return static_cast<Code>(((c.lanes >> 5) & ~0x07E0u) | ((c.lanes >> 26) << 5));
  }
  /// encode(c.packed()), straight from the words.
  [[nodiscard]] static constexpr Code encode(ColourSegment c) {
    const std::uint32_t levels = c.red_blue & 0x7C007C00u;  // what the other takes along leaves the code
    return static_cast<Code>((levels >> 15) | (levels >> 10) | ((c.green >> 25) << 5));
  }
  /// encode(c.packed()), straight from the words.
  template <bool Joined>
  [[nodiscard]] static constexpr Code encode(const BasicFineRgb<Joined>& c) {
    return c.rgb565();
  }
  [[nodiscard]] static constexpr Code encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return encode(Rgb8{dithered<5>(c.r, x, y), dithered<6>(c.g, x, y), dithered<5>(c.b, x, y)});
  }
  [[nodiscard]] static constexpr Rgb8 decode(Code code) {
    return {detail::expand_to_8<5>(static_cast<unsigned>(code >> 11)),
            detail::expand_to_8<6>(static_cast<unsigned>(code >> 5) & 63u),
            detail::expand_to_8<5>(static_cast<unsigned>(code) & 31u)};
  }
};

/// 24 bits, three bytes r, g, b.
struct Rgb888 {
  using Code = Rgb8;
  using Unit = Rgb8;
  using Cursor = detail::WordCursor<Rgb8>;
  static constexpr unsigned kBitsPerPixel = 24;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t units_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Code encode(Rgb8 c) { return c; }
  [[nodiscard]] static constexpr Code encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return c; }
  [[nodiscard]] static constexpr Rgb8 decode(Code code) { return code; }
};

/// 8-bit luma, a byte per pixel.
struct Gray8 {
  using Code = std::uint8_t;
  using Unit = std::uint8_t;
  using Cursor = detail::WordCursor<std::uint8_t>;
  static constexpr unsigned kBitsPerPixel = 8;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t units_per_row(std::int32_t width) {
    return static_cast<std::size_t>(width);
  }
  [[nodiscard]] static constexpr Code encode(Rgb8 c) { return luma(c); }
  [[nodiscard]] static constexpr Code encode_dithered(Rgb8 c, std::int32_t, std::int32_t) { return luma(c); }
  [[nodiscard]] static constexpr Rgb8 decode(Code code) { return {code, code, code}; }
};

/// 4-bit luma, two pixels a byte, the left one in the high nibble.
struct Gray4 {
  using Code = std::uint8_t;
  using Unit = std::uint8_t;
  using Cursor = detail::BitCursor<4>;
  static constexpr unsigned kBitsPerPixel = 4;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t units_per_row(std::int32_t width) {
    return (static_cast<std::size_t>(width) + 1) / 2;
  }
  [[nodiscard]] static constexpr Code encode(Rgb8 c) { return static_cast<Code>(luma(c) >> 4); }
  [[nodiscard]] static constexpr Code encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Code>(dithered<4>(luma(c), x, y) >> 4);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Code code) {
    const std::uint8_t v = detail::expand_to_8<4>(code);
    return {v, v, v};
  }
};

/// One bit, lit where the luma is at least 128; eight pixels a byte, the leftmost in the highest bit.
struct Mono {
  using Code = std::uint8_t;
  using Unit = std::uint8_t;
  using Cursor = detail::BitCursor<1>;
  static constexpr unsigned kBitsPerPixel = 1;
  static constexpr bool kDithers = false;

  [[nodiscard]] static constexpr std::size_t units_per_row(std::int32_t width) {
    return (static_cast<std::size_t>(width) + 7) / 8;
  }
  [[nodiscard]] static constexpr Code encode(Rgb8 c) { return static_cast<Code>(luma(c) >> 7); }
  [[nodiscard]] static constexpr Code encode_dithered(Rgb8 c, std::int32_t x, std::int32_t y) {
    return static_cast<Code>(dithered<1>(luma(c), x, y) >> 7);
  }
  [[nodiscard]] static constexpr Rgb8 decode(Code code) {
    const std::uint8_t v = detail::expand_to_8<1>(code);
    return {v, v, v};
  }
};

/// The format `F` with ordered dither before truncation.
template <PixelFormat F>
struct Dithered : F {
  static constexpr bool kDithers = true;
};

/// The code that format `F` stores for colour `c` at pixel (x, y) of the picture.
template <PixelFormat F>
[[nodiscard]] constexpr typename F::Code encode_at(PackedRgb c, std::int32_t x, std::int32_t y) {
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
[[nodiscard]] constexpr typename F::Code encode_at(const C& c, std::int32_t x, std::int32_t y) {
  if constexpr (!F::kDithers && requires { F::encode(c); }) {
    return F::encode(c);
  } else {
    return encode_at<F>(c.packed(), x, y);
  }
}

static_assert(PixelFormat<Rgb565> && PixelFormat<Rgb888> && PixelFormat<Gray8> && PixelFormat<Gray4> &&
              PixelFormat<Mono> && PixelFormat<Dithered<Rgb565>>);

}  // namespace arcspan
