// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/shading/arc/arc_edge.hpp>
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
    const auto rounded = [](std::uint32_t chord) { return (chord + (1u << 11)) >> 12; };
    const HalfChords at_top{rounded(frame.chords.top_middle), rounded(frame.chords.top_bottom),
                            rounded(frame.chords.middle_bottom)};
    const std::uint32_t at_middle = middle_row_angle(at_top, long_edge.shape, frame.middle_fraction);
    if (frame.has_upper) {
      make_row_angles(at_top, upper_edge.shape, long_edge.shape, frame.middle_fraction, at_middle, true,
                      upper_rows);
    }
    if (frame.has_lower) {
      const HalfChords at_bottom{at_top.bc, at_top.ac, at_top.ab};
      make_row_angles(at_bottom, lower_edge.shape, long_edge.shape, Factor::of(1.0) - frame.middle_fraction,
                      at_middle, false, lower_rows);
    }
  }
};

}  // namespace arcspan
