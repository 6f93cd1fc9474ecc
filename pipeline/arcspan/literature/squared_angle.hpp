// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>

#include <cstdint>

namespace arcspan {

/// Number of fraction bits of a SquaredAngle: 18 for squared angles below 1/8 (20 degrees), 16 below 1/2 (40
/// degrees), 15 up to 1.1 (60 degrees).
///
/// This is block fixed point: one format is chosen at run time per triangle or edge, by its widest arc, and
/// applies to all of its squared chords and angles. A squared angle is multiplied by 16-bit factors into 32
/// bits, so a wide angle leaves fewer fraction bits than a near one; using all that fit matters because an
/// error of the angle is an error of the shading. The format is a run-time value and not a template argument,
/// because three instantiations would triple the code.
enum class AngleFormat : std::uint8_t { kNear = 18, kMiddle = 16, kWide = 15 };

[[nodiscard]] constexpr int fraction_bits(AngleFormat format) { return static_cast<int>(format); }

/// Returns the format for arcs whose largest squared chord is `chord`, 28 fraction bits. A squared chord of
/// at most 0.119 keeps squared angles below 1/8, one of at most 0.47 below 1/2.
[[nodiscard]] constexpr AngleFormat angle_format(std::uint32_t chord) {
  return chord <= 31943819u    ? AngleFormat::kNear
         : chord <= 126164664u ? AngleFormat::kMiddle
                               : AngleFormat::kWide;
}

/// A squared chord, a squared angle in rad^2, or a factor that vanishes with it, such as ArcStart::even. The
/// raw value has fraction_bits(format) fraction bits, and the AngleFormat is passed beside it; the 0 in the
/// type means that the type does not know them. Sums, and products with a Factor by
/// multiply<SquaredAngle>(), keep the format. Multiplying by a SquaredAngle needs it: see times_angle().
using SquaredAngle = Fixed<std::int32_t, 0>;

/// Returns b * angle, rounded to nearest, in the format of b; `format` is that of `angle`.
template <class B>
[[nodiscard]] constexpr B times_angle(B b, SquaredAngle angle, AngleFormat format) {
  return B::from_raw(round_shift(wrap_mul(b.raw(), angle.raw()), fraction_bits(format)));
}

/// Returns a squared chord, given with 28 fraction bits, in `format`, rounded to nearest. It must fit (see
/// angle_format()).
[[nodiscard]] constexpr SquaredAngle scaled_chord(std::uint32_t chord, AngleFormat format) {
  const int drop = 28 - fraction_bits(format);
  return SquaredAngle::from_raw(
      static_cast<std::int32_t>((chord + (std::uint32_t{1} << (drop - 1))) >> drop));
}

}  // namespace arcspan
