// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/shading/arc/arc_angle.hpp>
#include <arcspan/shading/arc/recurrence.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// `Count` scalars on their way along one arc, with the step they share.
template <std::size_t Count>
struct ArcEdge {
  std::array<ArcScalar, Count> scalars;
  ArcStep step;

  /// A call: what it takes does not fit beside the rows anyway.
  ARCSPAN_OUTLINE constexpr void advance() {
    unrolled<Count>([this](auto i) { scalars[i].fine_step(step); });
  }
};

/// The step of an arc as a fraction a = mantissa * 2^-exponent <= 1 of it, mantissa in [2^15, 2^16].
struct ArcFraction {
  std::uint32_t mantissa = std::uint32_t{1} << 16;
  int exponent = 16;

  [[nodiscard]] constexpr Factor factor() const {
    return Factor::from_raw(static_cast<std::int32_t>(mantissa >> ((exponent - Factor::kFraction) & 31)));
  }
};

/// 1 / length as a fraction, where `inverse` is the reciprocal of the length with `bits` fraction bits; a
/// length below one step counts as one, for then there is no second pixel or row to step to.
[[nodiscard]] ARCSPAN_INLINE constexpr ArcFraction arc_fraction(const Reciprocal& inverse, int bits) {
  const int exponent = inverse.exponent - bits;
  if (exponent < 16) return {};
  return {inverse.mantissa, exponent};
}

/// How many bits of a Q1.30 slope are dropped before it meets the 16-bit mantissa of a fraction: slopes of
/// near arcs are below 1/2, of arcs up to a squared chord of 1/3 below 1, of wider ones below 2.
[[nodiscard]] constexpr int slope_drop(std::uint32_t chord) {
  return chord > (std::uint32_t{1} << 28) / 3 ? 16 : angle_format(chord) == AngleFormat::kNear ? 14 : 15;
}

/// How a slope of 1 over a whole arc becomes one per step: (slope >> drop) * mantissa >> down.
struct SlopeScale {
  std::int32_t mantissa;
  int drop;
  int down;
};

/// For differences with 30 + fine fraction bits, fine at most a.exponent - 16.
[[nodiscard]] constexpr SlopeScale slope_scale(const ArcFraction& a, int drop, int fine) {
  const int down = a.exponent - drop - fine;
  return {static_cast<std::int32_t>(a.mantissa), drop, down > 31 ? 31 : down};
}

/// One scalar at its start on an arc from value `from` to value `to` (see ArcStart); five 16-bit multiplies.
/// `format` is that of `start`.
[[nodiscard]] constexpr ArcScalar start_scalar(const ArcStart& start, AngleFormat format,
                                               const SlopeScale& scale, Cosine from, Cosine to) {
  const std::int32_t middle30 = wrap_add(from.raw() >> 1, to.raw() >> 1);
  const Factor middle = Factor::from_raw(round_shift(middle30, 15));
  const Factor rise = Factor::from_raw(round_shift(wrap_sub(to.raw(), from.raw()), 15));
  const int drop = fraction_bits(format) + Factor::kFraction - Cosine::kFraction;
  const auto of_middle = [middle, drop](SquaredAngle share) {
    return Cosine::from_raw(wrap_mul(share.raw(), middle.raw()) >> drop);
  };
  ArcScalar scalar;
  scalar.x = Cosine::from_raw(middle30) + of_middle(start.even) + multiply<Cosine>(start.odd, rise);
  const Cosine slope = multiply<Cosine>(start.slope_odd, rise) + of_middle(start.slope_even);
  // d is rounded down: half a unit of 2^-30 a step is nothing over the longest row.
  scalar.d = Cosine::from_raw(wrap_mul(round_shift(slope.raw(), scale.drop), scale.mantissa) >> scale.down);
  return scalar;
}

/// Scalars on their way down an edge, from the values `from` at its top to `to` at its bottom. `chord` is the
/// squared chord of the normals there.
template <std::size_t Count>
ARCSPAN_OUTLINE constexpr void make_arc_edge(const EdgeSetup& edge, std::uint32_t chord,
                                             const std::array<Cosine, Count>& from,
                                             const std::array<Cosine, Count>& to, ArcEdge<Count>& arc) {
  const AngleFormat format = angle_format(chord);
  const SquaredAngle angle2 = angle_of_chord(scaled_chord(chord, format), format);
  const ArcFraction row = arc_fraction(edge.inverse, Subpixel::kFraction);
  const ArcStart start = arc_start(angle2, format, start_fraction(edge), row.factor());
  // A difference is a slope below 2 times a, so that many of its leading bits are free; two stay so for k.
  const int fine = row.exponent > 18 ? row.exponent - 18 : 0;
  const SlopeScale scale = slope_scale(row, slope_drop(chord), fine);
  for (std::size_t i = 0; i < Count; ++i) {
    arc.scalars[i] = start_scalar(start, format, scale, from[i], to[i]);
  }
  arc.step = arc_step(angle2.raw(), fraction_bits(format), row.mantissa, row.exponent, fine);
}

}  // namespace arcspan
