// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A colour that changes linearly over at most 2^kFraction steps. It holds the three 10-bit channels of
/// PackedRgb with kFraction fraction bits each, which packed() drops.
///
/// `red_blue` holds red in bits 30...16 and blue in bits 14...0; `green` holds green in bits 30...16. Bit
/// 15 is free for the sign of a blue difference, which borrows from red. Sums of steps are exact in every
/// channel.
struct ColourSegment {
  static constexpr int kFraction = 5;

  std::uint32_t red_blue = 0;
  std::uint32_t green = 0;

  [[nodiscard]] static constexpr ColourSegment of(PackedRgb c) {
    return {((c.lanes << 10) & 0x7FE00000u) | ((c.lanes << kFraction) & 0x7FE0u),
            (c.lanes >> 1) & 0x7FE00000u};
  }
  /// Returns the step that reaches `end` after 2^bits steps. It is exact for bits in 0...kFraction.
  [[nodiscard]] constexpr ColourSegment step_to(ColourSegment end, int bits) const {
    return {static_cast<std::uint32_t>(static_cast<std::int32_t>(end.red_blue - red_blue) >> bits),
            static_cast<std::uint32_t>(static_cast<std::int32_t>(end.green - green) >> bits)};
  }
  constexpr void advance(ColourSegment step) {
    red_blue += step.red_blue;
    green += step.green;
  }
  [[nodiscard]] constexpr PackedRgb packed() const {
    return {((green << 1) & 0xFFC00000u) | ((red_blue >> 10) & 0x001FF800u) |
            ((red_blue >> kFraction) & 0x3FFu)};
  }
  /// The colour as an Rgb565 pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
    const std::uint32_t levels = red_blue & 0x7C007C00u;  // one shift per channel; the other one falls out
    return static_cast<std::uint16_t>((levels >> 15) | (levels >> 10) | ((green >> 25) << 5));
  }
};

}  // namespace arcspan
