// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// An angle in units of 2^-30 quarter turns, so that a whole turn wraps to 0.
using Angle32 = std::uint32_t;
inline constexpr Angle32 kQuarterTurn = std::uint32_t{1} << 30;

namespace detail {

/// Entry i is sin(i/256 of a quarter turn) by its series, 30 fraction bits. One more entry repeats the last,
/// so that entry i + 1 always exists. One function without helpers, because some targets reject double
/// parameters even at compile time.
consteval std::array<std::uint32_t, 258> make_sine_table() {
  std::array<std::uint32_t, 258> table{};
  constexpr double kHalfPi = 1.57079632679489661923;
  for (std::size_t i = 0; i <= 256; ++i) {
    const double x = kHalfPi * static_cast<double>(i) / 256;
    double term = x;
    double sum = x;
    for (int k = 1; k < 14; ++k) {
      term *= -x * x / ((2 * k) * (2 * k + 1));
      sum += term;
    }
    table[i] = static_cast<std::uint32_t>(sum * 0x1p30 + 0.5);
  }
  table[257] = table[256];
  return table;
}

inline constexpr std::array<std::uint32_t, 258> kSineTable = make_sine_table();

}  // namespace detail

/// The sine of an angle in 0...kQuarterTurn, 30 fraction bits, from a table of 257 entries with linear
/// interpolation. Absolute error at most 6e-6; relative error at most 5e-5 for angles from 2^-8 rad (both
/// swept in the tests).
[[nodiscard]] constexpr std::uint32_t quarter_sine(Angle32 angle) {
  const auto index = static_cast<std::size_t>(angle >> 22);
  const std::uint32_t fraction = (angle >> 6) & 0xFFFFu;
  const std::uint32_t here = detail::kSineTable[index];
  return here + ((((detail::kSineTable[index + 1] - here) >> 7) * fraction) >> 9);
}

/// The cosine of any angle, 30 fraction bits; errors as quarter_sine().
[[nodiscard]] constexpr std::int32_t cosine(Angle32 angle) {
  const Angle32 turned = (angle >> 31) == 0 ? angle : 0u - angle;  // cos is even; now in 0...half a turn
  if (turned <= kQuarterTurn) return static_cast<std::int32_t>(quarter_sine(kQuarterTurn - turned));
  return -static_cast<std::int32_t>(quarter_sine(turned - kQuarterTurn));
}

}  // namespace arcspan
