// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/arc_vertex.hpp>
#include <arcspan/literature/row_angles.hpp>
#include <arcspan/literature/row_pieces.hpp>
#include <arcspan/numbers/unroll.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::literature {

/// `Count` scalars along the arc of one edge. The edge's chord is stepped from row to row; the arc is
/// computed from it where a row is drawn.
template <std::size_t Count>
struct ArcEdge {
  EdgeFraction fraction;                 ///< from the upper end
  std::array<Cosine, Count> on_chord;    ///< at the current row
  std::array<Cosine, Count> step;        ///< change of `on_chord` per row
  std::array<std::int16_t, Count> base;  ///< ArcShape::base()
  ArcShape shape;

  /// Sets up the edge at its first row. `from` are the scalars at its top, `to` those at its bottom; `chord`
  /// is the squared chord between the normals there, 28 fraction bits.
  ARCSPAN_OUTLINE constexpr void prepare(const EdgeSetup& edge, std::uint32_t chord,
                                         const std::array<Cosine, Count>& from,
                                         const std::array<Cosine, Count>& to) {
    shape = ArcShape(chord);
    fraction = EdgeFraction::of(edge, true);
    const auto start = static_cast<std::uint32_t>(fraction.t >> 14);
    // An edge of less than a row has no second one. Its exponent may be below 20.
    const int down = edge.dy < 16 ? 31 : edge.inverse.exponent - 20;
    for (std::size_t i = 0; i < Count; ++i) {
      const std::int32_t along = wrap_sub(to[i].raw(), from[i].raw());
      on_chord[i] = from[i] + Cosine::from_raw(scaled_down(along, start, 16));
      step[i] = Cosine::from_raw(scaled_down(along, edge.inverse.mantissa, 16) >> down);
      base[i] = shape.base(from[i], to[i]);
    }
  }
  constexpr void advance() {
    fraction.advance();
    unrolled<Count>([this](auto i) { on_chord[i] += step[i]; });
  }
  /// Sets `scalars` to those at the current row.
  constexpr void set_scalars(std::array<Cosine, Count>& scalars) const {
    const std::int32_t excess = shape.excess(fraction.factor());
    unrolled<Count>([&](auto i) { scalars[i] = shape.on_arc(on_chord[i], base[i], excess); });
  }
};

/// A triangle whose normals are up to 60 degrees apart, to be drawn in pieces of rows (WideWalker): the arcs
/// of its edges and the angles of its rows. An edge or a half without rows to draw is not set.
template <std::size_t Count>
struct WideTriangle {
  ArcEdge<Count> long_edge;
  std::array<ArcEdge<Count>, 2> short_edges;  ///< of the upper and of the lower half
  std::array<RowAngles, 2> rows;
  Factor widest_piece;  ///< squared angle of a piece of a row, at most
  bool middle_left;     ///< the middle vertex is on the left of the long edge
  bool in_lower;        ///< the current row is in the lower half

  /// `Frame` is a TriangleFrame whose chords are measured and whose vertices are ArcVertex.
  template <class Frame>
  ARCSPAN_OUTLINE constexpr void prepare(Frame& frame, Factor widest) {
    widest_piece = widest;
    middle_left = frame.middle_left;
    in_lower = false;
    const NormalChords& chords = frame.chords;
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    long_edge.prepare(frame.long_edge, chords.top_bottom, top, bottom);
    const auto rounded = [](std::uint32_t chord) { return (chord + (1u << 11)) >> 12; };
    const HalfChords at_top{rounded(chords.top_middle), rounded(chords.top_bottom),
                            rounded(chords.middle_bottom)};
    const Factor t = frame.middle_fraction;
    const std::uint32_t at_middle = middle_row_angle(at_top, long_edge.shape, t);
    if (frame.has_upper) {
      short_edges[0].prepare(frame.upper_edge, chords.top_middle, top, middle);
      rows[0] = make_row_angles(at_top, short_edges[0].shape, long_edge.shape, t, at_middle, true);
    }
    if (frame.has_lower) {
      short_edges[1].prepare(frame.lower_edge, chords.middle_bottom, middle, bottom);
      const HalfChords at_bottom{at_top.bc, at_top.ac, at_top.ab};
      rows[1] = make_row_angles(at_bottom, short_edges[1].shape, long_edge.shape, Factor::of(1.0) - t,
                                at_middle, false);
    }
  }

  /// Sets `ends` to those of the current row and returns the pixels up to them (VeryWideTriangle::row()).
  [[nodiscard]] constexpr std::int32_t row(RowPixel&, RowEnds<Count>& ends) const {
    const ArcEdge<Count>& short_edge = short_edges[in_lower];
    ends.angle2 = rows[in_lower].squared(short_edge.fraction.factor());
    (middle_left ? short_edge : long_edge).set_scalars(ends.left);
    (middle_left ? long_edge : short_edge).set_scalars(ends.right);
    return INT32_MAX;
  }
  constexpr void next_row() {
    long_edge.advance();
    short_edges[in_lower].advance();
  }
  constexpr void enter_lower() { in_lower = true; }
};

}  // namespace arcspan::literature
