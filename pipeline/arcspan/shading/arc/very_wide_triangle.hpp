// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc_edge.hpp>
#include <arcspan/shading/arc/arc_vertex.hpp>
#include <arcspan/shading/arc/row_angles.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A triangle with normals more than 60 degrees apart. Both ends of each row are found from its vertices,
/// because the series of WideTriangle do not hold there. Such triangles are rare in meshes; a row takes some
/// thousand instructions.
template <std::size_t Count>
struct VeryWideTriangle {
  ArcVertex<Count> top;
  ArcVertex<Count> middle;
  ArcVertex<Count> bottom;
  EdgeFraction long_edge;  ///< from the upper end, as the others
  EdgeFraction upper_edge;
  EdgeFraction lower_edge;

  template <class Frame>
  ARCSPAN_COLD_OUTLINE constexpr void prepare(Frame& frame) {
    make_short_inverses(frame);
    top = frame.top->shade;
    middle = frame.middle->shade;
    bottom = frame.bottom->shade;
    long_edge = edge_fraction(frame.long_edge, true);
    if (frame.has_upper) upper_edge = edge_fraction(frame.upper_edge, true);
    if (frame.has_lower) lower_edge = edge_fraction(frame.lower_edge, true);
  }

  constexpr void next_row(bool in_lower) {
    long_edge.advance();
    (in_lower ? lower_edge : upper_edge).advance();
  }

  /// Returns the ends of the current row. A row of more than 60 degrees is halved; the ends are then those of
  /// the part in which `start` lies, and `start` becomes relative to it. Returns the pixels from there to the
  /// end of the part, INT32_MAX in the last one.
  [[nodiscard]] ARCSPAN_COLD_OUTLINE constexpr std::int32_t row(bool in_lower, bool middle_left,
                                                                RowStart& start, RowEnds<Count>& ends) const {
    const ArcVertex<Count> at_long = on_arc(top, bottom, long_edge.factor());
    const ArcVertex<Count> at_short =
        in_lower ? on_arc(middle, bottom, lower_edge.factor()) : on_arc(top, middle, upper_edge.factor());
    const ArcVertex<Count>& left = middle_left ? at_short : at_long;
    const ArcVertex<Count>& right = middle_left ? at_long : at_short;
    unrolled<Count>([&](auto i) {  // a copy of the whole would be a call of memcpy
      ends.left[i] = left.scalars[i];
      ends.right[i] = right.scalars[i];
    });
    std::uint32_t chord = squared_chord(at_long.normal, at_short.normal);
    std::int32_t length = INT32_MAX;
    while (chord > kWidestArc) {
      const HalfWay half(chord);
      const RowPiece part = piece_of_row(start, 1);
      auto& replaced = part.index != 0 ? ends.left : ends.right;
      for (std::size_t i = 0; i < Count; ++i) {
        replaced[i] = Cosine::from_raw(half.of(std::int64_t{ends.left[i].raw()} + ends.right[i].raw()));
      }
      start.inside = part.inside;
      start.width = part.width >> 1;
      start.bits = part.bits;
      if (part.length < length) length = part.length;
      chord = half.chord();
    }
    ends.angle2 = Factor::from_raw(static_cast<std::int32_t>(detail::squared_angle(chord >> 12) >> 1));
    return length;
  }
};

}  // namespace arcspan
