// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc_angle.hpp>
#include <arcspan/shading/arc/arc_edge.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The fraction of an edge at the current row, 30 fraction bits, counted from one of its ends.
struct EdgeFraction {
  std::int32_t t;   ///< 0...1
  std::int32_t dt;  ///< change per row

  [[nodiscard]] constexpr Factor factor() const { return Factor::from_raw(t >> 15); }
  constexpr void advance() { t = wrap_add(t, dt); }
};

/// Returns the fraction at the first row of an edge that has its reciprocal, counted from its upper end if
/// `from_top`, otherwise from its lower end.
[[nodiscard]] constexpr EdgeFraction edge_fraction(const EdgeSetup& edge, bool from_top) {
  constexpr std::uint32_t kOne = std::uint32_t{1} << 30;
  const int up = 30 - edge.inverse.exponent;
  const auto scaled = [up](std::uint32_t v) { return up >= 0 ? v << up : v >> -up; };
  const std::uint32_t step = edge.dy < 16 ? kOne : scaled(16 * edge.inverse.mantissa);
  const std::uint32_t start = scaled(static_cast<std::uint32_t>(edge.offset) * edge.inverse.mantissa);
  const std::uint32_t below_top = start > kOne ? kOne : start;
  if (from_top) return {static_cast<std::int32_t>(below_top), static_cast<std::int32_t>(step)};
  return {static_cast<std::int32_t>(kOne - below_top), -static_cast<std::int32_t>(step)};
}

/// The squared angles psi^2 of the rows of a half triangle, in rad^2. The half lies between two arcs that
/// leave one corner. At the fraction t of the height from the corner to the middle vertex, a row has
///
///     psi^2 = t^2 (corner + rise t^2),
///
/// because psi/t is an even function of t. psi^2 is exact at both ends; its error between them is of the
/// sixth order in the angle (2.4e-5 of psi^2 at 30 degrees, 2.8e-3 at 60).
struct RowAngles {
  Factor corner;   ///< psi^2 / t^2 at the corner
  Factor rise;     ///< its increase to the middle vertex
  EdgeFraction t;  ///< of the current row

  /// Returns psi^2 of the current row.
  [[nodiscard]] constexpr Factor squared() const {
    const Factor at = t.factor();
    const Factor t2 = multiply_floor<Factor>(at, at);
    return multiply_floor<Factor>(t2, corner + multiply_floor<Factor>(t2, rise));
  }
};

/// Sets up the rows of a half triangle at its first row. `at_corner` and `at_middle` are the results of
/// row_angle_at_corner() and row_angle_at_middle() in AngleFormat::kWide, and `edge` is the short edge of the
/// half, with its reciprocal. `from_top` is true if the corner is the upper end of that edge.
constexpr void make_row_angles(SquaredAngle at_corner, SquaredAngle at_middle, const EdgeSetup& edge,
                               bool from_top, RowAngles& rows) {
  static_assert(fraction_bits(AngleFormat::kWide) == Factor::kFraction);
  rows.corner = Factor::from_raw(at_corner.raw());
  rows.rise = Factor::from_raw((at_middle - at_corner).raw());
  rows.t = edge_fraction(edge, from_top);
}

}  // namespace arcspan
