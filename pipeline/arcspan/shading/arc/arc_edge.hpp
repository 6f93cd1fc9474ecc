// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/shading/arc/arc_shape.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The fraction of an edge at the current row, 30 fraction bits, counted from one of its ends.
struct EdgeFraction {
  std::int32_t t;   ///< 0...1
  std::int32_t dt;  ///< change per row

  [[nodiscard]] constexpr Factor factor() const { return Factor::from_raw(t >> 15); }
  constexpr void advance() { t = wrap_add(t, dt); }
  constexpr void advance(std::int32_t rows) { t = wrap_add(t, wrap_mul(dt, rows)); }
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

/// A scalar on the chord of an edge.
struct ChordScalar {
  Cosine x;     ///< at the current row
  Cosine step;  ///< its change per row
};

/// `Count` scalars along the arc of one edge. The edge's chord is stepped from row to row; the arc is
/// computed from it where a row is drawn.
template <std::size_t Count>
struct ArcEdge {
  EdgeFraction fraction;  ///< from the upper end
  std::array<ChordScalar, Count> on_chord;
  std::array<std::int16_t, Count> base;  ///< ArcShape::base()
  ArcShape shape;

  /// Returns the excess of the arc at the current row.
  [[nodiscard]] constexpr std::int32_t excess() const { return shape.excess(fraction.factor()); }
  /// Returns scalar i at the current row.
  [[nodiscard]] ARCSPAN_INLINE constexpr Cosine at(std::size_t i, std::int32_t excess) const {
    return shape.on_arc(on_chord[i].x, base[i], excess);
  }
  /// Steps the first `Used` scalars to the next row.
  template <std::size_t Used>
  constexpr void advance() {
    fraction.advance();
    unrolled<Used>([this](auto i) { on_chord[i].x += on_chord[i].step; });
  }
  /// Steps `rows` rows at once; the result is that of `rows` calls of advance().
  template <std::size_t Used>
  constexpr void advance(std::int32_t rows) {
    fraction.advance(rows);
    unrolled<Used>(
        [&](auto i) { on_chord[i].x += Cosine::from_raw(wrap_mul(on_chord[i].step.raw(), rows)); });
  }
};

/// Sets up the first `used` scalars of an edge at its first row. `from` are their values at its top, `to`
/// those at its bottom; `chord` is the squared chord between the normals there, 28 fraction bits.
template <std::size_t Count>
ARCSPAN_OUTLINE constexpr void make_arc_edge(const EdgeSetup& edge, std::uint32_t chord,
                                             const std::array<Cosine, Count>& from,
                                             const std::array<Cosine, Count>& to, std::size_t used,
                                             ArcEdge<Count>& arc) {
  arc.shape = ArcShape(chord);
  arc.fraction = edge_fraction(edge, true);
  const auto start = static_cast<std::uint32_t>(arc.fraction.t >> 14);
  // An edge of less than a row has no second one. Its exponent may be below 20.
  const int down = edge.dy < 16 ? 31 : edge.inverse.exponent - 20;
  for (std::size_t i = 0; i < used; ++i) {
    const std::int32_t along = wrap_sub(to[i].raw(), from[i].raw());
    arc.on_chord[i].x = from[i] + Cosine::from_raw(scaled_down(along, start, 16));
    arc.on_chord[i].step = Cosine::from_raw(scaled_down(along, edge.inverse.mantissa, 16) >> down);
    arc.base[i] = arc.shape.base(from[i], to[i]);
  }
}

}  // namespace arcspan
