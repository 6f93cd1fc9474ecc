// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/spread_rgb565.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::overlay::detail {

/// A colour that is mixed with the pixels below it, as the pixel format `F` shows it: in Mono each is black
/// or white, and so is the mixture.
template <PixelFormat F>
class MixedColour {
 public:
  using Encoded = typename F::Encoded;
  static constexpr std::uint32_t kOpaque = 32;

  explicit constexpr MixedColour(Encoded encoded) : encoded_(encoded), colour_(F::decode(encoded)) {}

  /// The pixel with a share of `share` / 32 of the colour, 0...32, and the rest of `below`.
  [[nodiscard]] constexpr Encoded over(Encoded below, std::uint32_t share) const {
    if (share >= kOpaque) return encoded_;
    const Rgb8 other = F::decode(below);
    const auto mixed = [share](std::uint32_t a, std::uint32_t b) {
      return static_cast<std::uint8_t>((a * share + b * (kOpaque - share) + kOpaque / 2) / kOpaque);
    };
    return F::encode({mixed(colour_.r, other.r), mixed(colour_.g, other.g), mixed(colour_.b, other.b)});
  }

 private:
  Encoded encoded_;
  Rgb8 colour_;
};

/// With all channels in one word.
template <PixelFormat F>
requires arcspan::detail::Rgb565Words<F>
class MixedColour<F> {
 public:
  static constexpr std::uint32_t kOpaque = 32;

  explicit constexpr MixedColour(std::uint16_t encoded)
      : spread_(arcspan::detail::spread(F::word565(encoded))) {}
  [[nodiscard]] constexpr std::uint16_t over(std::uint16_t below, std::uint32_t share) const {
    return F::word565(arcspan::detail::joined(
        arcspan::detail::mixed_spread(arcspan::detail::spread(F::word565(below)), spread_, share)));
  }

 private:
  std::uint32_t spread_;
};

}  // namespace arcspan::overlay::detail
