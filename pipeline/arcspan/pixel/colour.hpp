// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace arcspan {

/// A colour as the span stage produces it: three 8-bit channels, 0 dark to 255 full.
struct Rgb8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend constexpr bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// Three channels in one word, each with 8 bits and 2 fraction bits to which half a step has been added, so
/// that dropping them rounds: g in bits 31...22, r in 20...11, b in 9...0. What shading hands to pixel
/// formats. Red and blue lie as far apart as in a 5-6-5 pixel, and have a bit above each for a carry.
struct PackedRgb {
  std::uint32_t lanes = 0;

  /// Channels in 0...1023.
  [[nodiscard]] static constexpr PackedRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    return {(g << 22) | (r << 11) | b};
  }
  [[nodiscard]] constexpr Rgb8 rgb8() const {
    return {static_cast<std::uint8_t>(lanes >> 13), static_cast<std::uint8_t>(lanes >> 24),
            static_cast<std::uint8_t>(lanes >> 2)};
  }

  /// The same value, 0...1023, in every channel.
  [[nodiscard]] static constexpr PackedRgb grey(std::uint32_t v) { return {v * 0x00400801u}; }

  /// Every channel plus the other's, saturated.
  [[nodiscard]] constexpr PackedRgb plus(PackedRgb other) const {
    if constexpr (kHasWideRegisters) {
      std::uint64_t sum = std::uint64_t{lanes} + other.lanes;
      hide_value(sum);  // or it is made twice, once of each width
      if ((sum & (kCarries | std::uint64_t{1} << 32)) == 0) [[likely]] {
        return {static_cast<std::uint32_t>(sum)};
      }
      return saturated(static_cast<std::uint32_t>(sum), (sum >> 32) != 0);
    } else {
      const std::uint32_t sum = lanes + other.lanes;
      const bool green_carry = sum < lanes;  // it left the word
      if (!green_carry) {                    // apart from the rest, as processors have it in a flag
        if ((sum & kCarries) == 0) [[likely]] {
          return {sum};
        }
      }
      return saturated(sum, green_carry);
    }
  }

 private:
  static constexpr std::uint32_t kCarries = 0x00200400;

  /// A sum whose red and blue carry as it shows, and green or not.
  [[nodiscard]] static constexpr PackedRgb saturated(std::uint32_t sum, bool green_carry) {
    const std::uint32_t carries = sum & kCarries;
    const std::uint32_t green = green_carry ? ~std::uint32_t{0} << 22 : sum;
    return {(green & (~std::uint32_t{0} << 22)) | ((sum | (carries - (carries >> 10))) & 0x001FFBFF)};
  }
};

/// A colour in other words, which runs may hand to pixel formats in place of a PackedRgb.
template <class C>
concept PackableColour = requires(const C& colour) {
  { colour.packed() } -> std::same_as<PackedRgb>;
};

/// The largest of three channels' values, in whatever unit they have.
[[nodiscard]] constexpr std::uint32_t largest_channel(const std::array<std::uint32_t, 3>& channels) {
  const std::uint32_t two = channels[0] > channels[1] ? channels[0] : channels[1];
  return two > channels[2] ? two : channels[2];
}

/// Luma of `c`, 0...255: the BT.601 weights 0.299, 0.587, 0.114 in eighths of a byte (77, 150, 29 of 256),
/// rounded. A neutral grey keeps its value exactly, since the weights sum to 256.
[[nodiscard]] constexpr std::uint8_t luma(Rgb8 c) {
  return static_cast<std::uint8_t>((77u * c.r + 150u * c.g + 29u * c.b + 128u) >> 8);
}

}  // namespace arcspan
