// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_shape.hpp>
#include <arcspan/literature/recurrence_edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The squared angles psi^2 of the rows of a half triangle and the factors k of their pixels' recurrence. The
/// half lies between two arcs that leave one corner. At the fraction t of the height from the corner to the
/// middle vertex, a row has
///
///     psi^2 = t^2 (corner + rise t^2),      k = k_corner + k_rise t^2,
///
/// because psi/t is an even function of t. psi^2 is exact at both ends; its error between them is of the
/// sixth order in the angle (2.4e-5 of psi^2 at 30 degrees, 2.8e-3 at 60).
struct RecurrenceRows {
  std::int32_t corner;         ///< psi^2 / t^2 at the corner, in the rows' AngleFormat
  std::int32_t rise;           ///< its increase to the middle vertex, in the rows' AngleFormat
  std::int32_t k_corner;       ///< mantissa of k at the corner (RecurrenceStep)
  std::int32_t k_rise;         ///< its increase to the middle vertex
  std::int32_t k_shift;        ///< shift of k for all rows
  literature::EdgeFraction t;  ///< of the current row
};

/// Sets up the rows of a half triangle at its first row. `at_corner` and `at_middle` are the results of
/// row_angle_at_corner() and row_angle_at_middle() in `format`, `width` is the reciprocal of the length in
/// pixels of the row at the middle vertex (16 fraction bits), and `edge` is the short edge of the half, with
/// its reciprocal. `from_top` is true if the corner is the upper end of that edge.
ARCSPAN_OUTLINE constexpr void make_recurrence_rows(SquaredAngle at_corner, SquaredAngle at_middle,
                                                    AngleFormat format, const Reciprocal& width,
                                                    const EdgeSetup& edge, bool from_top,
                                                    RecurrenceRows& rows) {
  rows.corner = at_corner.raw();
  rows.rise = (at_middle - at_corner).raw();
  const ArcFraction pixel = arc_fraction(width, 16);
  const RecurrenceStep corner =
      recurrence_step(at_corner.raw(), fraction_bits(format), pixel.mantissa, pixel.exponent, 0);
  const RecurrenceStep middle =
      recurrence_step(at_middle.raw(), fraction_bits(format), pixel.mantissa, pixel.exponent, 0);
  rows.k_shift = corner.shift < middle.shift ? corner.shift : middle.shift;
  rows.k_corner = corner.mantissa >> (corner.shift - rows.k_shift);
  rows.k_rise = (middle.mantissa >> (middle.shift - rows.k_shift)) - rows.k_corner;

  rows.t = literature::EdgeFraction::of(edge, from_top);
}

}  // namespace arcspan
