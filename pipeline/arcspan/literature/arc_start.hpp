// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/squared_angle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The factors that give the value x of a scalar at the fraction u of an arc, and its first difference for a
/// step of the fraction a of the arc, from the scalar's values I0 and I1 at the two ends:
///
///     x    = M + even * M + odd * D,         M = (I0 + I1) / 2,  D = I1 - I0
///     diff = a * (slope_odd * D + slope_even * M)
///
/// The factors depend on the angle psi of the arc, u and a only, so all scalars share them. They follow from
/// x(u) = [sin((1-u) psi) I0 + sin(u psi) I1] / sin(psi) (S0 eq. 2) with c = u - 1/2 and v = c + a/2:
///
///     1 + even   = cos(c psi) / cos(psi/2)
///     odd        = sin(c psi) / (2 sin(psi/2))
///     slope_even = -2 sin(v psi) sin(a psi/2) / (a cos(psi/2))
///     slope_odd  = cos(v psi) sin(a psi/2) / (a sin(psi/2))
///
/// and are computed as series in psi^2. The SquaredAngles are in the format of psi^2.
struct ArcStart {
  SquaredAngle even;
  Factor odd;
  Factor slope_odd;
  SquaredAngle slope_even;
};

/// Returns the factors of an arc with the squared angle p = psi^2 in `format`; u and a are in 0...1. By
/// polynomials in p that are fitted to the series: the error of x is at most 6e-5 up to 60 degrees, that of
/// the value that diff reaches at the end of the arc 2e-4, plus rounding. Edges and clipped vertices share
/// this one function, which is not inlined.
[[nodiscard]] ARCSPAN_OUTLINE constexpr ArcStart arc_start(SquaredAngle p, AngleFormat format, Factor u,
                                                           Factor a) {
  constexpr Factor kOne = Factor::of(1.0);
  constexpr Factor kHalf = Factor::of(0.5);
  const auto times_p = [p, format](auto b) { return times_angle(b, p, format); };
  const Factor c = u - kHalf;
  const Factor c2 = multiply<Factor>(c, c);
  const Factor v = c + Factor::from_raw(a.raw() >> 1);
  const Factor v2 = multiply<Factor>(v, v);
  const Factor a2 = multiply<Factor>(a, a);
  const SquaredAngle p_parabola = multiply<SquaredAngle>(p, Factor::of(0.25) - c2);  // p (1/4 - c^2)

  ArcStart start;
  // even = p (1/4 - c^2) (1/2 + p (0.05181 - 0.04667 c^2 + 0.00617 p))
  const Factor even_rate =
      Factor::of(0.05181) - multiply<Factor>(c2, Factor::of(0.04667)) + times_p(Factor::of(0.00617));
  start.even = multiply<SquaredAngle>(p_parabola, kHalf + times_p(even_rate));
  // odd = c (1 + p (1/4 - c^2) (1/6 + 0.0043 p))
  const Factor odd_inner = Factor::of(1.0 / 6) + times_p(Factor::of(0.0043));
  start.odd = c + times_angle(c, multiply<SquaredAngle>(p_parabola, odd_inner), format);
  // slope_odd = 1 + p [(1 - a^2) / 24 + 0.00125 p - v^2 (1/2 + p (0.0214 - 0.0429 v^2))]
  const Factor slope_odd_inner = Factor::of(0.0214) - multiply<Factor>(v2, Factor::of(0.0429));
  const Factor slope_odd_v2 = multiply<Factor>(v2, kHalf + times_p(slope_odd_inner));
  const Factor slope_odd_rate =
      multiply<Factor>(kOne - a2, Factor::of(1.0 / 24)) + times_p(Factor::of(0.00125)) - slope_odd_v2;
  start.slope_odd = kOne + times_p(slope_odd_rate);
  // slope_even = -v p [1 + p (1/8 - a^2/24 + 0.0144 p - v^2 (1/6 + 0.0206 p))]
  const Factor slope_even_v2 = multiply<Factor>(v2, Factor::of(1.0 / 6) + times_p(Factor::of(0.0206)));
  const Factor slope_even_rate = Factor::of(0.125) - multiply<Factor>(a2, Factor::of(1.0 / 24)) +
                                 times_p(Factor::of(0.0144)) - slope_even_v2;
  start.slope_even = -multiply<SquaredAngle>(multiply<SquaredAngle>(p, v), kOne + times_p(slope_even_rate));
  return start;
}

}  // namespace arcspan
