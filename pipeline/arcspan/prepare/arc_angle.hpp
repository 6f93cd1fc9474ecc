// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/arc_start.hpp>
#include <arcspan/prepare/recurrence.hpp>

#include <cstdint>

namespace arcspan {

/// psi^2 of a squared chord s = 2 - 2 cos(psi): s + s^2/12 + s^3/90 + s^4/560 (of 4 asin^2(sqrt(s)/2)).
[[nodiscard]] constexpr Factor angle_of_chord(Factor s) {
  const Factor inner = Factor::of(1.0 / 90) + multiply<Factor>(s, Factor::of(1.0 / 560 + 0.0004));
  const Factor outer = Factor::of(1.0 / 12) + multiply<Factor>(s, inner);
  return s + multiply<Factor>(multiply<Factor>(s, s), outer);
}

/// psi / sin(psi) of a squared chord: 1 + s/6 + s^2/30 + s^3/140.
[[nodiscard]] constexpr Factor angle_over_sine(Factor s) {
  const Factor inner = Factor::of(1.0 / 30) + multiply<Factor>(s, Factor::of(1.0 / 140 + 0.002));
  return Factor::of(1.0) + multiply<Factor>(s, Factor::of(1.0 / 6) + multiply<Factor>(s, inner));
}

/// Squared chords between the three normals of a triangle with corner A: |A-B|^2, |A-C|^2, |B-C|^2; at
/// most 1.
struct CornerChords {
  Factor ab;
  Factor ac;
  Factor bc;
};

/// Squared angle of a row, extrapolated from the corner A where the row is a point: rows cut AB whole and AC
/// at the fraction `t`. There the law of cosines is the plane one for the tangents psi/sin(psi) (B - A cos
/// psi),
///     psi_row^2 = psi_ab^2 + t^2 psi_ac^2 - 2 t T_ab·T_ac.
[[nodiscard]] constexpr Factor row_angle_at_corner(const CornerChords& s, Factor t) {
  const Factor edges = Factor::from_raw((s.ab.raw() + s.ac.raw() - s.bc.raw()) / 2);
  const Factor product = edges - Factor::from_raw(multiply<Factor>(s.ab, s.ac).raw() >> 2);
  const Factor tangents =
      multiply<Factor>(multiply<Factor>(product, angle_over_sine(s.ab)), angle_over_sine(s.ac));
  const Factor far = multiply<Factor>(multiply<Factor>(t, t), angle_of_chord(s.ac));
  const Factor cross = multiply<Factor>(t, tangents);
  const Factor row = angle_of_chord(s.ab) + far - cross - cross;
  return row.raw() < 0 ? Factor{} : row;
}

/// Squared angle of the row through B: from B to the point of the arc AC at the fraction t from A.
/// With N = w(1-t) A + w(t) C:  |N - B|^2 = w(1-t) |A-B|^2 + w(t) |B-C|^2 - 2 (w(1-t) + w(t) - 1).
[[nodiscard]] constexpr Factor row_angle_at_middle(const CornerChords& s, Factor t) {
  const ArcStart at = arc_start(angle_of_chord(s.ac), t, Factor{});
  const Factor half_sum = Factor::from_raw((Factor::of(1.0) + at.even).raw() >> 1);
  const Factor weight_c = half_sum + at.odd;
  const Factor weight_a = half_sum - at.odd;
  const Factor chord =
      multiply<Factor>(weight_a, s.ab) + multiply<Factor>(weight_c, s.bc) - at.even - at.even;
  return chord.raw() < 0 ? Factor{} : angle_of_chord(chord);
}

}  // namespace arcspan
