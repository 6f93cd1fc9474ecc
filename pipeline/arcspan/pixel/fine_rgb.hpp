// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A colour that Gouraud shading steps along a row: three channels in 8-bit steps with 23 fraction bits, one
/// word each and below 2^31, so that a shift without a mask gives the upper bits. A channel includes half an
/// 8-bit step, so that dropping the fraction rounds.
class FineRgb {
 public:
  static constexpr int kFraction = 23;

  FineRgb() = default;  // not an aggregate, so that encode({r, g, b}) takes an Rgb8

  /// The colour of three channels in 0...2^31 - 1, or a step of three signed gradients.
  [[nodiscard]] static constexpr FineRgb of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
    FineRgb c{};
    c.r_ = r;
    c.g_ = g;
    c.b_ = b;
    return c;
  }
  ARCSPAN_INLINE constexpr void advance(const FineRgb& step) {
    r_ += step.r_;
    g_ += step.g_;
    b_ += step.b_;
  }

  [[nodiscard]] constexpr std::uint32_t r() const { return r_; }
  [[nodiscard]] constexpr std::uint32_t g() const { return g_; }
  [[nodiscard]] constexpr std::uint32_t b() const { return b_; }
  [[nodiscard]] ARCSPAN_INLINE constexpr PackedRgb packed() const {
    constexpr int kShift = kFraction - 2;
    return PackedRgb::of(r_ >> kShift, g_ >> kShift, b_ >> kShift);
  }
  /// The colour as an Rgb565 pixel.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t rgb565() const {
    constexpr int kToSixBits = kFraction + 2;  // a shift from the top of a word needs no mask
    const std::uint32_t red_green = ((r_ >> (kToSixBits + 1)) << 6) | (g_ >> kToSixBits);
    return static_cast<std::uint16_t>((red_green << 5) | (b_ >> (kToSixBits + 1)));
  }

 private:
  std::uint32_t r_;
  std::uint32_t g_;
  std::uint32_t b_;
};

}  // namespace arcspan
