// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_start.hpp>
#include <arcspan/literature/recurrence.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <initializer_list>

namespace arcspan {

/// Returns the squared angle psi^2 = 4 asin^2(sqrt(s)/2) of the squared chord s = 2 - 2 cos(psi), s at most
/// 1, by the series s + s^2/12 + s^3/90 + s^4/560. The last coefficient is increased by 0.0004 for the terms
/// that are left out.
[[nodiscard]] ARCSPAN_OUTLINE constexpr SquaredAngle angle_of_chord(SquaredAngle s, AngleFormat format) {
  const Factor inner = Factor::of(1.0 / 90) + times_angle(Factor::of(1.0 / 560 + 0.0004), s, format);
  const Factor outer = Factor::of(1.0 / 12) + times_angle(inner, s, format);
  return s + multiply<SquaredAngle>(times_angle(s, s, format), outer);
}

/// Returns psi / sin(psi) - 1 of a squared chord s, at most 1, by the series s/6 + s^2/30 + s^3/140. The last
/// coefficient is increased by 0.002 for the terms that are left out.
[[nodiscard]] constexpr SquaredAngle angle_over_sine_less_1(SquaredAngle s, AngleFormat format) {
  const Factor inner = Factor::of(1.0 / 30) + times_angle(Factor::of(1.0 / 140 + 0.002), s, format);
  return multiply<SquaredAngle>(s, Factor::of(1.0 / 6) + times_angle(inner, s, format));
}

/// Squared chords between the normals A, B, C of a triangle: |A-B|^2, |A-C|^2, |B-C|^2, each at most 1. A is
/// the corner at which a half of the triangle ends, B the middle vertex, C the other end of the long edge.
struct CornerChords {
  SquaredAngle ab;
  SquaredAngle ac;
  SquaredAngle bc;
};

/// Returns the squared angle of the row through B, extrapolated from the corner A, where rows shrink to a
/// point; `t` is the fraction of AC at which that row meets it. Near A the law of cosines is the plane one,
///
///     psi_row^2 = psi_ab^2 + t^2 psi_ac^2 - 2 t T_ab·T_ac,
///
/// where T_ab = psi/sin(psi) (B - A cos psi) is the tangent at A of the arc AB, and T_ac that of AC.
[[nodiscard]] ARCSPAN_OUTLINE constexpr SquaredAngle row_angle_at_corner(const CornerChords& s,
                                                                         AngleFormat format, Factor t) {
  const SquaredAngle edges = SquaredAngle::from_raw((s.ab.raw() + s.ac.raw() - s.bc.raw()) / 2);
  SquaredAngle tangents = edges - SquaredAngle::from_raw(times_angle(s.ab, s.ac, format).raw() >> 2);
  for (const SquaredAngle side : {s.ab, s.ac}) {
    tangents += times_angle(tangents, angle_over_sine_less_1(side, format), format);
  }
  const SquaredAngle beyond = multiply<SquaredAngle>(multiply<Factor>(t, t), angle_of_chord(s.ac, format));
  const SquaredAngle cross = multiply<SquaredAngle>(t, tangents);
  const SquaredAngle row = angle_of_chord(s.ab, format) + beyond - cross - cross;
  return row.raw() < 0 ? SquaredAngle{} : row;
}

/// Returns the squared angle of the row through B: between B and the normal N at the fraction t of the arc
/// AC, t from A. N = w(1-t) A + w(t) C with the weights w of S0 eq. 2, hence
///
///     |N - B|^2 = w(1-t) |A-B|^2 + w(t) |B-C|^2 - 2 (w(1-t) + w(t) - 1).
[[nodiscard]] constexpr SquaredAngle row_angle_at_middle(const CornerChords& s, AngleFormat format,
                                                         Factor t) {
  const ArcStart at = arc_start(angle_of_chord(s.ac, format), format, t, Factor{});
  const int drop = fraction_bits(format) - Factor::kFraction;
  const std::int32_t even = drop == 0 ? at.even.raw() : round_shift(at.even.raw(), drop);
  const Factor half_sum = Factor::of(0.5) + Factor::from_raw(even >> 1);
  const Factor weight_c = half_sum + at.odd;
  const Factor weight_a = half_sum - at.odd;
  const SquaredAngle chord =
      multiply<SquaredAngle>(weight_a, s.ab) + multiply<SquaredAngle>(weight_c, s.bc) - at.even - at.even;
  return chord.raw() < 0 ? SquaredAngle{} : angle_of_chord(chord, format);
}

}  // namespace arcspan
