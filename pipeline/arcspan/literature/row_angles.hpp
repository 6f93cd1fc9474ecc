// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_shape.hpp>

#include <cstdint>

namespace arcspan::literature {

/// Squared chords between the normals A, B, C of a triangle: |A-B|^2, |A-C|^2, |B-C|^2, each at most 1, 16
/// fraction bits. A is the corner at which a half of the triangle ends, B the middle vertex, C the other end
/// of the long edge.
struct HalfChords {
  std::uint32_t ab;
  std::uint32_t ac;
  std::uint32_t bc;
};

/// Returns factor * value, `factor` with 15 fraction bits.
[[nodiscard]] constexpr std::uint32_t times(std::uint32_t factor, std::uint32_t value) {
  return (factor * value) >> 15;
}

/// Returns the squared angle psi^2 = 4 asin^2(sqrt(s)/2) of a squared chord s, at most 1, by the series s +
/// s^2/12 + s^3/90 + s^4/560, of which the last coefficient is increased for the terms that are left out.
/// Both have 16 fraction bits.
[[nodiscard]] constexpr std::uint32_t squared_angle(std::uint32_t s) {
  const std::uint32_t factor = s >> 1;
  return s + times(factor, times(factor, 5461 + times(factor, 728 + times(factor, 143))));
}

/// The normal at a fraction of the arc from A to C: weight_a A + weight_c C.
struct ArcWeights {
  std::uint32_t excess;  ///< 16 fraction bits
  std::uint32_t a;       ///< 15 fraction bits
  std::uint32_t c;       ///< 15 fraction bits; both sum to 1 + excess

  constexpr ArcWeights(const ArcShape& shape, Factor t) {
    constexpr Cosine kOne = Cosine::from_raw(std::int32_t{1} << 30);
    const Cosine on_chord = kOne - Cosine::from_raw(wrap_shl(t.raw(), 15));
    const std::int32_t above = shape.excess(t);
    a = static_cast<std::uint32_t>(shape.on_arc(on_chord, shape.base(kOne, {}), above).raw()) >> 15;
    excess = static_cast<std::uint32_t>(above) >> 2;
    c = 32768u + (excess >> 1) - a;
  }
};

/// The squared angles psi^2 of the rows of a half triangle, in rad^2. The half lies between two arcs that
/// leave one corner. At the fraction t of the height from the corner to the middle vertex, a row has
///
///     psi^2 = t^2 (corner + rise t^2),
///
/// because psi/t is an even function of t. psi^2 is exact at t = 1/2 and at t = 1; elsewhere its error is at
/// most 7e-6 up to 30 degrees and 6.3e-4 up to 60.
struct RowAngles {
  Factor corner;  ///< psi^2 / t^2 at the corner
  Factor rise;    ///< its increase to the middle vertex
  Factor origin;  ///< fraction of the short edge at the corner, from its upper end: 0 or 1

  /// Returns psi^2 of the row at a fraction of the short edge.
  [[nodiscard]] constexpr Factor squared(Factor fraction) const {
    // Rounded down, which saves an addition where half a unit of bias does no harm.
    const auto product = [](Factor a, Factor b) {
      return Factor::from_raw(wrap_mul(a.raw(), b.raw()) >> Factor::kFraction);
    };
    const Factor t = fraction - origin;
    const Factor t2 = product(t, t);
    return product(t2, corner + product(t2, rise));
  }
};

/// Returns the squared angle of the row through B: between B and the normal at the fraction t of the arc from
/// A to C, whose shape is `ac`. 16 fraction bits.
[[nodiscard]] constexpr std::uint32_t middle_row_angle(const HalfChords& s, const ArcShape& ac, Factor t) {
  const ArcWeights at(ac, t);
  const std::uint32_t sum = times(at.a, s.ab) + times(at.c, s.bc);
  return sum <= 2 * at.excess ? 0 : squared_angle(sum - 2 * at.excess);
}

/// Returns the rows of a half triangle. The row half-way to the middle row lies between the middle of the arc
/// AB and the fraction t/2 of the arc AC. `at_middle` is middle_row_angle(); `from_top` is true if A is the
/// top vertex.
[[nodiscard]] constexpr RowAngles make_row_angles(const HalfChords& s, const ArcShape& ab, const ArcShape& ac,
                                                  Factor t, std::uint32_t at_middle, bool from_top) {
  const ArcWeights on_ac(ac, Factor::from_raw(t.raw() >> 1));
  const auto excess = static_cast<std::uint32_t>(ab.excess(Factor::of(0.5))) >> 2;
  // |N - M|^2 of N = a A + c C and M = w (A + B), with w = (1 + excess) / 2, a + c = 1 + on_ac.excess
  const std::uint32_t sum = times(on_ac.a, s.ab) + times(on_ac.c, s.ac + s.bc);
  const std::uint32_t above = 2 * (excess + on_ac.excess + times(excess >> 1, on_ac.excess));
  const std::uint32_t chord = times(16384u + (excess >> 2), sum);
  const std::uint32_t at_half = chord <= above ? 0 : squared_angle(chord - above);
  // psi^2 = corner + rise at the middle row, and (corner + rise / 4) / 4 half-way to it; 5461 = 2^15 / 6.
  const auto difference = static_cast<std::int32_t>(16 * at_half) - static_cast<std::int32_t>(at_middle);
  const std::int32_t corner = difference < 0 ? 0 : wrap_mul(difference >> 2, 5461) >> 13;
  return {Factor::from_raw(corner), Factor::from_raw(static_cast<std::int32_t>(at_middle >> 1) - corner),
          from_top ? Factor{} : Factor::of(1.0)};
}

}  // namespace arcspan::literature
