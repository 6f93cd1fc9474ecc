// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/formats.hpp>

#include <cstdint>

namespace arcspan {

/// How a scalar and its first difference follow from the scalar's values at the two ends of an arc of angle
/// psi, at a fraction u of it and one step of the fraction a further:
///
///     x    = M + even * M + odd * D,         M = (I0 + I1) / 2,  D = I1 - I0
///     diff = a * (slope_odd * D + slope_even * M)
///
/// From x(u) = [sin((1-u) psi) I0 + sin(u psi) I1] / sin(psi) (S0 eq. 2) with c = u - 1/2 and v = c + a/2:
///     1 + even   = cos(c psi) / cos(psi/2)
///     odd        = sin(c psi) / (2 sin(psi/2))
///     slope_even = -2 sin(v psi) sin(a psi/2) / (a cos(psi/2))
///     slope_odd  = cos(v psi) sin(a psi/2) / (a sin(psi/2))
/// each as a series in psi^2. The factors hold for every scalar of the arc. `Angle` is the format of psi^2
/// and of the two factors that vanish with it.
template <class Angle>
struct ArcStart {
  Angle even;
  Factor odd;
  Factor slope_odd;
  Angle slope_even;
};

/// Any arc up to the limit of `Angle`; `u` and `a` in 0...1. Second order: error of x and of the end that
/// diff leads to at most 2e-5 up to 30 degrees and 2e-3 at 60, beside rounding.
template <class Angle>
[[nodiscard]] constexpr ArcStart<Angle> arc_start(Angle angle2, Factor u, Factor a) {
  constexpr Factor kOne = Factor::of(1.0);
  constexpr Factor kHalf = Factor::of(0.5);
  const Angle p = angle2;
  const Factor c = u - kHalf;
  const Factor c2 = multiply<Factor>(c, c);
  const Factor v = c + Factor::from_raw(a.raw() >> 1);
  const Factor v2 = multiply<Factor>(v, v);
  const Factor a2 = multiply<Factor>(a, a);
  const Angle bow = multiply<Angle>(p, Factor::of(0.25) - c2);

  ArcStart<Angle> start;
  // even = (p/2) (1/4 - c^2) (1 + p (5/4 - c^2) / 12)
  const Factor even_rise = multiply<Factor>(multiply<Angle>(p, Factor::of(1.25) - c2), Factor::of(1.0 / 24));
  start.even = multiply<Angle>(bow, kHalf + even_rise);
  // odd = c (1 + p (1/4 - c^2) (1/6 + 0.0043 p))
  const Factor odd_rise = Factor::of(1.0 / 6) + multiply<Factor>(p, Factor::of(0.0043));
  start.odd = c + multiply<Factor>(c, multiply<Angle>(bow, odd_rise));
  // slope_odd = 1 + p [(1 - a^2) / 24 + 0.0012 p - v^2 (1/2 + 0.0104 p)]
  const Factor odd_fall = multiply<Factor>(v2, kHalf + multiply<Factor>(p, Factor::of(0.0104)));
  const Factor odd_rate =
      multiply<Factor>(kOne - a2, Factor::of(1.0 / 24)) + multiply<Factor>(p, Factor::of(0.0012)) - odd_fall;
  start.slope_odd = kOne + multiply<Factor>(p, odd_rate);
  // slope_even = -v p [1 + p (1/8 - a^2/24 + 0.0130 p - v^2 (1/6 + 0.0188 p))]
  const Factor even_fall =
      multiply<Factor>(v2, Factor::of(1.0 / 6) + multiply<Factor>(p, Factor::of(0.0188)));
  const Factor even_rate = Factor::of(0.125) - multiply<Factor>(a2, Factor::of(1.0 / 24)) +
                           multiply<Factor>(p, Factor::of(0.0130)) - even_fall;
  start.slope_even = -multiply<Angle>(multiply<Angle>(v, p), kOne + multiply<Factor>(p, even_rate));
  return start;
}

/// A near arc, psi^2 below 1/8 (20 degrees): first order, which is within 2e-5 there and 5e-6 at 10 degrees,
/// and three more bits for the angle. Most rows of finely divided meshes are such.
[[nodiscard]] constexpr ArcStart<NearAngle> arc_start(NearAngle angle2, Factor u, Factor a) {
  constexpr Factor kOne = Factor::of(1.0);
  constexpr Factor kTwentyFourth = Factor::of(1.0 / 24);
  constexpr Factor kSixth = Factor::of(1.0 / 6);
  const NearAngle p = angle2;
  const Factor c = u - Factor::of(0.5);
  const Factor v = c + Factor::from_raw(a.raw() >> 1);
  const Factor v2 = multiply_floor<Factor>(v, v);
  const NearAngle bow = multiply_floor<NearAngle>(p, u - multiply_floor<Factor>(u, u));

  ArcStart<NearAngle> start;
  // (5/4 - c^2) / 24 is 0.042...0.052.
  start.even = multiply_floor<NearAngle>(bow, Factor::of(0.5) + multiply_floor<Factor>(p, Factor::of(0.047)));
  start.odd = c + multiply_floor<Factor>(c, multiply_floor<NearAngle>(bow, kSixth));
  const Factor fall = kTwentyFourth - multiply_floor<Factor>(multiply_floor<Factor>(a, a), kTwentyFourth) -
                      Factor::from_raw(v2.raw() >> 1);
  start.slope_odd = kOne + multiply<Factor>(p, fall);
  const Factor gain =
      kOne + multiply_floor<Factor>(p, Factor::of(0.125) - multiply_floor<Factor>(v2, kSixth));
  start.slope_even = -multiply<NearAngle>(multiply<NearAngle>(v, p), gain);
  return start;
}

}  // namespace arcspan
