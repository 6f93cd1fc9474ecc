// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace arcspan {

/// A colour with 8 bits per channel, from 0 (dark) to 255 (full).
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// The colour that shading passes to pixel formats: three channels in one word, g in bits 31...22, r
/// in 20...11, b in 9...0. A channel has 8 bits and 2 fraction bits and includes half an 8-bit step, so that
/// dropping the fraction rounds. Red and blue are as far apart as in a 5-6-5 pixel, and each has a bit above
/// it for a carry.
struct PackedRgb {
  std::uint32_t lanes = 0;

  /// The colour of three channels, each in 0...1023.
  [[nodiscard]] static constexpr PackedRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return {(g << 22) | (r << 11) | b};
  }
  /// Channels of 8 bits, with the half step.
  [[nodiscard]] static constexpr PackedRgb of(Rgb8 c) { return of(4u * c.r + 2, 4u * c.g + 2, 4u * c.b + 2); }
  [[nodiscard]] constexpr Rgb8 rgb8() const {
    return {static_cast<std::uint8_t>(lanes >> 13), static_cast<std::uint8_t>(lanes >> 24),
            static_cast<std::uint8_t>(lanes >> 2)};
  }

  /// The same value, 0...1023, in every channel.
  [[nodiscard]] static constexpr PackedRgb grey(std::uint32_t v) { return {v * 0x00400801u}; }

  /// The sum of two colours per channel, saturated.
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb plus(PackedRgb other) const {
    std::uint32_t sum = lanes + other.lanes;
    const bool green_carry = sum < lanes;  // out of the word
    if (green_carry || (sum & kCarries) != 0) [[unlikely]] {
      sum = saturated(sum, green_carry).lanes;
    }
    return {sum};
  }

 private:
  static constexpr std::uint32_t kCarries = 0x00200400;

  /// `sum` with every channel that has carried set to 1023. The carries of red and blue are in `sum`.
  [[nodiscard]] ARCSPAN_INLINE static constexpr PackedRgb saturated(std::uint32_t sum, bool green_carry) {
    const std::uint32_t carries = sum & kCarries;
    // A carry is the bit above its channel: it is cleared, and the ten bits below it are set.
    const std::uint32_t rest = (sum - carries) | (carries - (carries >> 10));
    return {green_carry ? rest | ~std::uint32_t{0} << 22 : rest};
  }
};

/// A colour in another layout, which runs may pass to pixel formats in place of a PackedRgb.
template <class C>
concept PackableColour = requires(const C& colour) {
  { colour.packed() } -> std::same_as<PackedRgb>;
};

/// Optional part of a colour: covers(x, y) is false where the pixel is not drawn, and its depth neither.
template <class C>
concept MaskedColour = requires(const C& c, std::int32_t x) {
  { c.covers(x, x) } -> std::same_as<bool>;
};

/// Optional part of a colour: alpha() is the opacity of its texel, 0...16.
template <class C>
concept AlphaColour = requires(const C& c) {
  { c.alpha() } -> std::same_as<std::uint32_t>;
};

/// A run with an operation that depends on the layer of depths: fog. enter_layer() is called before each
/// piece of a row, and sets the fog of the piece. It gets the depth of the piece's first pixel, the change of
/// the depth per pixel, and the number of pixels left in the row; it returns how many of them the piece has.
/// Its parameter is kOperates565 of the pixel format.
template <class R, class Lighting>
concept LayeredRun = requires(R run, const Lighting& lighting, Linear z, std::int32_t left) {
  { run.template enter_layer<true>(lighting, z, z, left) } -> std::same_as<std::int32_t>;
};

/// Optional part of a colour: over(below) is the colour blended with `below`, the pixel that is there, as
/// PackedRgb with half steps; over565(pixel) the same as 5-6-5 pixels. Blending is the last operation.
template <class C>
concept BlendedColour = requires(const C& c, PackedRgb below, std::uint16_t pixel) {
  { c.over(below) } -> std::same_as<PackedRgb>;
  { c.over565(pixel) } -> std::same_as<std::uint16_t>;
};

/// The largest of three channels.
[[nodiscard]] constexpr std::uint32_t largest_channel(const std::array<std::uint32_t, 3>& channels) {
  const std::uint32_t two = channels[0] > channels[1] ? channels[0] : channels[1];
  return two > channels[2] ? two : channels[2];
}

/// The luma of `c`, 0...255, by the weights of BT.601 (0.299, 0.587, 0.114 as 77, 150, 29 of 256), rounded. A
/// grey keeps its value exactly, because the weights add up to 256.
[[nodiscard]] constexpr std::uint8_t luma(Rgb8 c) {
  return static_cast<std::uint8_t>((77u * c.r + 150u * c.g + 29u * c.b + 128u) >> 8);
}

}  // namespace arcspan
