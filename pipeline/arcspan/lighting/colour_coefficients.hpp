// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/lighting/power_table.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Coefficients from integers, at run time or as constants. A coefficient of 1 is a channel of 255 on the
/// panel: coefficients are display values, as sRGB bytes are, and light is added in them.
namespace arcspan {

/// byte / 255, rounded.
[[nodiscard]] constexpr Coefficient coefficient_of(std::uint8_t byte) {
  return Coefficient::from_raw((byte * 32768 + 127) / 255);
}

/// The coefficients of a surface that shows the sRGB colour `colour` in full light.
[[nodiscard]] constexpr ChannelCoefficients coefficients_of(Rgb8 colour) {
  return {coefficient_of(colour.r), coefficient_of(colour.g), coefficient_of(colour.b)};
}

/// Sets `coefficient` to part / whole, rounded: 35 of 100 for 35 %. Returns kInvalidArgument, and changes
/// nothing, unless 0 <= part <= whole and 0 < whole.
[[nodiscard]] constexpr Status make_coefficient(std::int32_t part, std::int32_t whole,
                                                Coefficient& coefficient) {
  if (part < 0 || whole <= 0 || part > whole) return Status::kInvalidArgument;
  const auto divisor = static_cast<std::uint32_t>(whole);
  const std::uint64_t dividend = (std::uint64_t{static_cast<std::uint32_t>(part)} << 15) + divisor / 2;
  coefficient = Coefficient::from_raw(static_cast<std::int32_t>(dividend / divisor));
  return Status::kOk;
}

namespace detail {

/// The light of the sRGB value c = byte / 255 (IEC 61966-2-1), c / 12.92 or ((c + 0.055) / 1.055)^2.4, 15
/// fraction bits. In integers, because compilers that may not use a floating-point unit refuse functions of
/// floating point, even for constants.
[[nodiscard]] constexpr std::uint16_t linear_light(std::uint32_t byte) {
  if (byte <= 10) return static_cast<std::uint16_t>((byte * 3276800 + 164730) / 329460);
  constexpr int kBits = 31;
  const auto base =
      static_cast<std::uint32_t>(((std::uint64_t{byte * 1000 + 14025} << kBits) + 134512) / 269025);
  const std::uint32_t square = power_of(base, 2);
  std::uint32_t root = 0;  // the fifth root of the square, by bisection
  for (std::uint32_t bit = std::uint32_t{1} << kBits; bit != 0; bit >>= 1) {
    if (root + bit <= std::uint32_t{1} << kBits && power_of(root + bit, 5) <= square) root += bit;
  }
  const std::uint64_t product = std::uint64_t{square} * root;  // 62 fraction bits
  return static_cast<std::uint16_t>((product + (std::uint64_t{1} << 46)) >> 47);
}

[[nodiscard]] consteval std::array<std::uint16_t, 256> make_linear_table() {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) table[i] = linear_light(i);
  return table;
}

/// Entry i is the light of the sRGB byte i, 15 fraction bits.
inline constexpr std::array<std::uint16_t, 256> kLinearTable = make_linear_table();

}  // namespace detail

/// The light of an sRGB byte, linear: what a physical calculation takes, such as one of light strengths. Not
/// a coefficient of a material, which is a display value.
[[nodiscard]] constexpr Coefficient linear_from_srgb(std::uint8_t byte) {
  return Coefficient::from_raw(detail::kLinearTable[byte]);
}

/// The sRGB byte whose light is nearest to `linear`: for colours of files that are linear, such as the base
/// colours of glTF. What is below 0 or above 1 saturates.
[[nodiscard]] constexpr std::uint8_t srgb_from_linear(Coefficient linear) {
  const std::int32_t light = linear.raw() < 0 ? 0 : linear.raw() > 32768 ? 32768 : linear.raw();
  std::size_t below = 0;
  for (std::size_t step = 128; step != 0; step >>= 1) {
    if (detail::kLinearTable[below + step] <= light) below += step;
  }
  if (below == 255) return 255;
  const std::int32_t here = detail::kLinearTable[below];
  const std::int32_t next = detail::kLinearTable[below + 1];
  return static_cast<std::uint8_t>(below + (light - here > next - light ? 1 : 0));
}

/// A material of one sRGB colour with a white highlight, like plastic: 20 % ambient, 80 % diffuse and 50 %
/// specular light.
[[nodiscard]] constexpr Material plastic(Rgb8 colour, std::int32_t shininess = 32) {
  const auto share = [colour](std::int32_t fifths) {
    const auto channel = [fifths](std::uint8_t byte) {
      return Coefficient::from_raw((byte * fifths * 32768 + 637) / 1275);
    };
    return ChannelCoefficients{channel(colour.r), channel(colour.g), channel(colour.b)};
  };
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  return {share(1), share(4), {kHalf, kHalf, kHalf}, shininess};
}

}  // namespace arcspan
