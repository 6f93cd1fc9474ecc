// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/row_angles.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A triangle whose normals are too far apart for a patch, up to 60 degrees: the arcs of its edges, each at
/// its first row, and the angles of its rows. An edge or a half without rows to draw is not set.
template <std::size_t Count>
struct WideTriangle {
  ArcEdge<Count> long_edge;
  ArcEdge<Count> upper_edge;
  ArcEdge<Count> lower_edge;
  RowAngles upper_rows;
  RowAngles lower_rows;

  /// Sets up the first `used` scalars. `Frame` is a TriangleFrame whose chords are measured and whose
  /// vertices are ArcVertex.
  template <class Frame>
  ARCSPAN_OUTLINE constexpr void prepare(Frame& frame, std::size_t used) {
    const TriangleChords& chords = frame.chords;
    const auto& top = frame.top->shade.scalars;
    const auto& middle = frame.middle->shade.scalars;
    const auto& bottom = frame.bottom->shade.scalars;
    make_short_inverses(frame);
    make_arc_edge(frame.long_edge, chords.top_bottom, top, bottom, used, long_edge);
    if (frame.has_upper) make_arc_edge(frame.upper_edge, chords.top_middle, top, middle, used, upper_edge);
    if (frame.has_lower)
      make_arc_edge(frame.lower_edge, chords.middle_bottom, middle, bottom, used, lower_edge);
    prepare_rows(frame);
  }

 private:
  /// Sets up the rows of both halves.
  template <class Frame>
  constexpr void prepare_rows(const Frame& frame) {
    constexpr AngleFormat kFormat = AngleFormat::kWide;
    const SquaredAngle top_middle = scaled_chord(frame.chords.top_middle, kFormat);
    const SquaredAngle top_bottom = scaled_chord(frame.chords.top_bottom, kFormat);
    const SquaredAngle middle_bottom = scaled_chord(frame.chords.middle_bottom, kFormat);
    const CornerChords at_top{top_middle, top_bottom, middle_bottom};
    const SquaredAngle at_middle = row_angle_at_middle(at_top, kFormat, frame.middle_fraction);
    if (frame.has_upper) {
      const SquaredAngle corner = row_angle_at_corner(at_top, kFormat, frame.middle_fraction);
      make_row_angles(corner, at_middle, frame.upper_edge, true, upper_rows);
    }
    if (frame.has_lower) {
      const CornerChords at_bottom{middle_bottom, top_bottom, top_middle};
      const SquaredAngle corner =
          row_angle_at_corner(at_bottom, kFormat, Factor::of(1.0) - frame.middle_fraction);
      make_row_angles(corner, at_middle, frame.lower_edge, false, lower_rows);
    }
  }
};

}  // namespace arcspan
