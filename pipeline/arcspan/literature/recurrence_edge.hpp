// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_angle.hpp>
#include <arcspan/literature/recurrence.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// `Count` scalars that are stepped along the arc of one edge; they share the factor of the recurrence.
template <std::size_t Count>
struct RecurrenceEdge {
  std::array<RecurrenceScalar, Count> scalars;
  RecurrenceStep step;

  /// Steps the first `Used` scalars to the next row. The function is not inlined, because its registers do
  /// not fit beside those of the row loop.
  template <std::size_t Used>
  ARCSPAN_OUTLINE constexpr void advance() {
    unrolled<Used>([this](auto i) { scalars[i].fine_step(step); });
  }
};

/// One step as a fraction of an arc: mantissa * 2^-exponent, at most 1, mantissa in [2^15, 2^16].
struct ArcFraction {
  std::uint32_t mantissa = std::uint32_t{1} << 16;
  int exponent = 16;

  [[nodiscard]] constexpr Factor factor() const {
    return Factor::from_raw(static_cast<std::int32_t>(mantissa >> ((exponent - Factor::kFraction) & 31)));
  }
};

/// Returns 1 / length, where `inverse` is the reciprocal of the length in pixels or rows with `bits` fraction
/// bits. A length below one step counts as one, since there is no second pixel or row to step to.
[[nodiscard]] ARCSPAN_INLINE constexpr ArcFraction arc_fraction(const Reciprocal& inverse, int bits) {
  const int exponent = inverse.exponent - bits;
  if (exponent < 16) return {};
  return {inverse.mantissa, exponent};
}

/// Returns the number of bits that a 2.30 slope over an arc must lose before it is multiplied by the 16-bit
/// mantissa of an ArcFraction: 14, 15 or 16. Slopes are below 1/2 for near arcs, below 1 up to a squared
/// chord of 1/3, and below 2 for wider arcs. `chord` is the squared chord with 28 fraction bits.
[[nodiscard]] constexpr int slope_drop(std::uint32_t chord) {
  return chord > (std::uint32_t{1} << 28) / 3 ? 16 : angle_format(chord) == AngleFormat::kNear ? 14 : 15;
}

/// Converts a slope over a whole arc to one per step: ((slope >> drop) * mantissa) >> down.
struct SlopeScale {
  std::int32_t mantissa;
  int drop;
  int down;
};

/// Returns the scale for steps of the fraction `a` and differences with 30 + fine fraction bits; fine is at
/// most a.exponent - 16.
[[nodiscard]] constexpr SlopeScale slope_scale(const ArcFraction& a, int drop, int fine) {
  const int down = a.exponent - drop - fine;
  return {static_cast<std::int32_t>(a.mantissa), drop, down > 31 ? 31 : down};
}

/// Returns a scalar and its first difference at the start of an arc from the value `from` to the value `to`
/// (see ArcStart), by five 16-bit multiplies. `format` is that of `start`.
[[nodiscard]] constexpr RecurrenceScalar start_scalar(const ArcStart& start, AngleFormat format,
                                                      const SlopeScale& scale, Cosine from, Cosine to) {
  const std::int32_t middle30 = wrap_add(from.raw() >> 1, to.raw() >> 1);
  const Factor middle = Factor::from_raw(round_shift(middle30, 15));
  const Factor difference = Factor::from_raw(round_shift(wrap_sub(to.raw(), from.raw()), 15));
  const int drop = fraction_bits(format) + Factor::kFraction - Cosine::kFraction;
  const auto times_middle = [middle, drop](SquaredAngle factor) {
    return Cosine::from_raw(wrap_mul(factor.raw(), middle.raw()) >> drop);
  };
  RecurrenceScalar scalar;
  scalar.x = Cosine::from_raw(middle30) + times_middle(start.even) + multiply<Cosine>(start.odd, difference);
  const Cosine slope = multiply<Cosine>(start.slope_odd, difference) + times_middle(start.slope_even);
  // d is rounded down: half a unit of 2^-30 per step is negligible over the longest row.
  scalar.d = Cosine::from_raw(wrap_mul(round_shift(slope.raw(), scale.drop), scale.mantissa) >> scale.down);
  return scalar;
}

/// Sets up the first `used` scalars of an edge at its first row. `from` are their values at its top, `to`
/// those at its bottom; `chord` is the squared chord between the normals there, 28 fraction bits.
template <std::size_t Count>
ARCSPAN_OUTLINE constexpr void make_recurrence_edge(const EdgeSetup& edge, std::uint32_t chord,
                                                    const std::array<Cosine, Count>& from,
                                                    const std::array<Cosine, Count>& to, std::size_t used,
                                                    RecurrenceEdge<Count>& arc) {
  const AngleFormat format = angle_format(chord);
  const SquaredAngle angle2 = angle_of_chord(scaled_chord(chord, format), format);
  const ArcFraction row = arc_fraction(edge.inverse, Subpixel::kFraction);
  const ArcStart start = arc_start(angle2, format, edge.start, row.factor());
  // A difference is a slope below 2 times `a`, which leaves its leading bits unused. The fine bits take all
  // of them except two, which k needs.
  const int fine = row.exponent > 18 ? row.exponent - 18 : 0;
  const SlopeScale scale = slope_scale(row, slope_drop(chord), fine);
  for (std::size_t i = 0; i < used; ++i) {
    arc.scalars[i] = start_scalar(start, format, scale, from[i], to[i]);
  }
  arc.step = recurrence_step(angle2.raw(), fraction_bits(format), row.mantissa, row.exponent, fine);
}

}  // namespace arcspan
