// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>

#include <cstdint>

namespace arcspan {

/// The formats of squared chords and angles, by their fraction bits: of near arcs, below 1/8 (20 degrees), of
/// middling ones, below 1/2 (40 degrees), and of any up to 1.1 (60 degrees). As many bits as fit, for the
/// error of an angle is an error of the shading. A number and not a type: code for each would be three times
/// the code.
enum class AngleFormat : std::uint8_t { kNear = 18, kMiddle = 16, kWide = 15 };

[[nodiscard]] constexpr int fraction_bits(AngleFormat c) { return static_cast<int>(c); }

/// By the squared chord of the widest arc concerned, 28 fraction bits: 0.119 keeps angles below 1/8, 0.47
/// below 1/2.
[[nodiscard]] constexpr AngleFormat angle_format(std::uint32_t chord) {
  return chord <= 31943819u    ? AngleFormat::kNear
         : chord <= 126164664u ? AngleFormat::kMiddle
                               : AngleFormat::kWide;
}

/// A squared chord or angle, or a factor that vanishes with it, in the units of its AngleFormat. It may be
/// multiplied into its own format; times_angle() multiplies by it.
using SquaredAngle = Fixed<std::int32_t, 0>;

/// b * angle, rounded, in the format of b.
template <class B>
[[nodiscard]] constexpr B times_angle(B b, SquaredAngle angle, AngleFormat c) {
  return B::from_raw(round_shift(wrap_mul(b.raw(), angle.raw()), fraction_bits(c)));
}

/// A squared chord with 28 fraction bits, rounded; it must fit.
[[nodiscard]] constexpr SquaredAngle scaled_chord(std::uint32_t chord, AngleFormat c) {
  const int drop = 28 - fraction_bits(c);
  return SquaredAngle::from_raw(
      static_cast<std::int32_t>((chord + (std::uint32_t{1} << (drop - 1))) >> drop));
}

}  // namespace arcspan
