// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc_edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The angle of the rows between two arcs that leave one corner, and the step of their pixels. A row at the
/// fraction t of the way from the corner to the middle vertex has
///
///     psi^2 = t^2 (corner + rise t^2),      k = k_corner + k_rise t^2,
///
/// since psi/t is an even function of t; the first is exact at both ends, the error between them is of the
/// sixth order in the angle (2.4e-5 of psi^2 at 30 degrees, 2.8e-3 at 60).
struct ArcRows {
  std::int32_t corner;  ///< in the rows' AngleFormat
  std::int32_t rise;
  std::int32_t k_corner;
  std::int32_t k_rise;
  std::int32_t k_shift;
  std::int32_t t;   ///< of the first row, 30 fraction bits
  std::int32_t dt;  ///< per row
};

/// Rows of a half triangle. `at_corner` and `at_middle` are psi^2 as of arc_angle.hpp, `width` the reciprocal
/// of the row's length in pixels at the middle vertex. `edge` is the half's short edge; `from_top` tells at
/// which of its ends the corner is.
ARCSPAN_OUTLINE constexpr void make_arc_rows(SquaredAngle at_corner, SquaredAngle at_middle,
                                             AngleFormat format, const Reciprocal& width,
                                             const EdgeSetup& edge, bool from_top, ArcRows& rows) {
  rows.corner = at_corner.raw();
  rows.rise = (at_middle - at_corner).raw();
  const ArcFraction pixel = arc_fraction(width, 16);
  const ArcStep corner = arc_step(at_corner.raw(), fraction_bits(format), pixel.mantissa, pixel.exponent, 0);
  const ArcStep middle = arc_step(at_middle.raw(), fraction_bits(format), pixel.mantissa, pixel.exponent, 0);
  rows.k_shift = corner.shift < middle.shift ? corner.shift : middle.shift;
  rows.k_corner = corner.mantissa >> (corner.shift - rows.k_shift);
  rows.k_rise = (middle.mantissa >> (middle.shift - rows.k_shift)) - rows.k_corner;

  constexpr std::uint32_t kOne = std::uint32_t{1} << 30;
  const int up = 30 - edge.inverse.exponent;
  const auto scaled = [up](std::uint32_t v) { return up >= 0 ? v << up : v >> -up; };
  const std::uint32_t step = edge.dy < 16 ? kOne : scaled(16 * edge.inverse.mantissa);
  const std::uint32_t start = scaled(static_cast<std::uint32_t>(edge.offset) * edge.inverse.mantissa);
  const std::uint32_t below_top = start > kOne ? kOne : start;
  rows.t = static_cast<std::int32_t>(from_top ? below_top : kOne - below_top);
  rows.dt = from_top ? static_cast<std::int32_t>(step) : -static_cast<std::int32_t>(step);
}

}  // namespace arcspan
