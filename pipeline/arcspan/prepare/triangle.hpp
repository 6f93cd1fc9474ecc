// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/linear.hpp>
#include <arcspan/target.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// A vertex as triangle preparation takes it: where it is, and what the shading method knows of it.
template <class Method>
struct RasterVertex {
  RasterPosition position;
  typename Method::Vertex shade;
};

/// The rows that are to be drawn of a viewport, relative to the raster origin: first ... end - 1.
struct RowRange {
  std::int32_t first = 0;
  std::int32_t end = 0;
};

/// Twice the signed area in 256ths of a square pixel; negative if a, b, c go counter-clockwise as seen on the
/// screen (y down), which is how front faces arrive. Exact: by the guard band it fits 32 bits.
[[nodiscard]] constexpr std::int32_t doubled_area(const RasterPosition& a, const RasterPosition& b,
                                                  const RasterPosition& c) {
  return wrap_sub(wrap_mul(b.x - a.x, c.y - a.y), wrap_mul(c.x - a.x, b.y - a.y));
}

/// The command that the span stage takes. Plain integers; nothing else passes from preparation to spans, so
/// the span stage can as well be another core or a piece of hardware. docs/triangle-command.md is its layout.
///
/// The rows from first_row to end_row - 1 lie between `left` and `right`; at middle_row the lower edge takes
/// over on the side of the middle vertex. Edges stand at the first row they are used in.
template <class Method>
struct TriangleCommand {
  std::int16_t first_row;  ///< relative to the raster origin
  std::int16_t middle_row;
  std::int16_t end_row;
  bool middle_left;  ///< the middle vertex is on the left of the long edge
  EdgeWalk left;
  EdgeWalk right;
  EdgeWalk lower;
  LinearPlane depth;
  typename Method::Prepared shade;

  /// True if one of the command's rows is among top ... bottom - 1, when the raster origin is in row
  /// `origin`.
  [[nodiscard]] constexpr bool has_rows_in(std::int32_t top, std::int32_t bottom, std::int32_t origin) const {
    return end_row + origin > top && first_row + origin < bottom;
  }
  /// Moves every edge by `pixels` columns.
  ARCSPAN_INLINE constexpr void move_columns(std::int32_t pixels) {
    const auto shift = static_cast<std::int64_t>(static_cast<std::uint64_t>(pixels) << 32);
    left.x += shift;
    right.x += shift;
    lower.x += shift;
  }
};

/// Squared chords of a triangle's edges, 28 fraction bits.
struct TriangleChords {
  std::uint32_t top_middle;
  std::uint32_t top_bottom;
  std::uint32_t middle_bottom;

  [[nodiscard]] constexpr std::uint32_t widest() const {
    const std::uint32_t upper = top_middle > top_bottom ? top_middle : top_bottom;
    return upper > middle_bottom ? upper : middle_bottom;
  }
};

/// What preparation knows of a triangle while it sets up attributes: vertices by height, edges as walked.
template <class Method>
struct TriangleFrame {
  const RasterVertex<Method>* top;
  const RasterVertex<Method>* middle;
  const RasterVertex<Method>* bottom;
  EdgeSetup long_edge;
  EdgeSetup upper_edge;
  EdgeSetup lower_edge;
  TriangleChords chords;  ///< between the normals, of methods that MeasureChords
  bool has_upper;         ///< rows of the upper half will be drawn
  bool has_lower;
  bool middle_left;
  Factor middle_fraction;  ///< fraction of the long edge at the middle vertex's height
  std::uint32_t width;     ///< of the triangle at that height, 16 fraction bits, at least 1
  Reciprocal inverse_width;
};

/// Completes the reciprocals of the short edges, for methods that interpolate along both edges of a row.
template <class Method>
constexpr void make_short_inverses(TriangleFrame<Method>& frame) {
  if (frame.middle_left || !kHasLongMultiply) return;
  if (frame.has_upper) frame.upper_edge.make_inverse();
  if (frame.has_lower) frame.lower_edge.make_inverse();
}

/// A 16-bit attribute with the given values at the top, middle and bottom vertex as a plane over the rows.
template <class Value, class Method>
constexpr void make_linear_plane(const TriangleFrame<Method>& frame, std::int32_t top, std::int32_t middle,
                                 std::int32_t bottom, BasicLinearPlane<Value>& plane) {
  constexpr int kBits = kFractionBits<Value>;
  const std::int32_t fraction = frame.middle_fraction.raw() >> (Factor::kFraction - kBits);
  const std::int32_t along = round_shift(wrap_mul(bottom - top, fraction), kBits);
  const std::int32_t across = middle - (top + along);
  plane.dx = gradient<Value>(frame.middle_left ? -across : across, frame.inverse_width, 16);
  // What no row uses is 0.
  if (!frame.middle_left) {
    make_linear_edge(frame.long_edge, top, bottom, plane.left);
    plane.lower = {};
    return;
  }
  if (frame.has_upper) {
    make_linear_edge(frame.upper_edge, top, middle, plane.left);
  } else {
    plane.left = {};
  }
  if (frame.has_lower) {
    make_linear_edge(frame.lower_edge, middle, bottom, plane.lower);
  } else {
    plane.lower = {};
  }
}

namespace detail {

template <class Vertex>
constexpr void order_by_height(const Vertex*& upper, const Vertex*& lower) {
  if (lower->position.y < upper->position.y) {
    const Vertex* const held = upper;
    upper = lower;
    lower = held;
  }
}

/// The rows of the command; false if there are none.
template <class Method>
[[nodiscard]] constexpr bool place_rows(const TriangleFrame<Method>& frame, const RowRange& rows,
                                        TriangleCommand<Method>& command) {
  const auto clamped = [&rows](std::int32_t row) {
    return row < rows.first ? rows.first : row > rows.end ? rows.end : row;
  };
  const std::int32_t first = clamped(first_row_at(frame.top->position.y));
  const std::int32_t middle = clamped(first_row_at(frame.middle->position.y));
  const std::int32_t end = clamped(first_row_at(frame.bottom->position.y));
  command.first_row = static_cast<std::int16_t>(first);
  command.middle_row = static_cast<std::int16_t>(middle);
  command.end_row = static_cast<std::int16_t>(end);
  return first < end;
}

/// Walks the edges that have rows to draw, and measures the triangle at its middle vertex.
template <class Method>
constexpr void place_edges(TriangleFrame<Method>& frame, TriangleCommand<Method>& command) {
  const RasterPosition& top = frame.top->position;
  const RasterPosition& middle = frame.middle->position;
  const RasterPosition& bottom = frame.bottom->position;
  frame.has_upper = command.first_row < command.middle_row;
  frame.has_lower = command.middle_row < command.end_row;
  EdgeWalk& long_walk = frame.middle_left ? command.right : command.left;
  make_edge_setup(top, bottom, command.first_row, true, frame.long_edge);
  make_edge_walk(frame.long_edge, bottom, long_walk);
  if (frame.has_upper) {
    make_edge_setup(top, middle, command.first_row, frame.middle_left, frame.upper_edge);
    make_edge_walk(frame.upper_edge, middle, frame.middle_left ? command.left : command.right);
  }
  if (frame.has_lower) {
    make_edge_setup(middle, bottom, command.middle_row, frame.middle_left, frame.lower_edge);
    make_edge_walk(frame.lower_edge, bottom, command.lower);
  }
  const auto height = static_cast<std::uint32_t>(middle.y - top.y);
  frame.middle_fraction = Factor::from_raw(static_cast<std::int32_t>(
      (height * frame.long_edge.inverse.mantissa) >> (frame.long_edge.inverse.exponent - Factor::kFraction)));
  const std::int64_t across = (std::int64_t{middle.x - top.x} << 28) - (scaled(long_walk.step, height) >> 4);
  const std::int64_t width = (across < 0 ? -across : across) >> 16;
  frame.width = width < 1 ? 1u : static_cast<std::uint32_t>(width);
  frame.inverse_width = nonzero_reciprocal(frame.width);
}

}  // namespace detail

/// Methods whose triangles depend on the chords between their normals: they are measured once.
template <class M>
concept MeasuresChords = requires(const TriangleFrame<M>& frame) {
  { M::chords_of(frame) } -> std::same_as<TriangleChords>;
};

namespace detail {

/// Sorts the vertices by height, and measures what lies between their normals.
template <class Method>
constexpr void place_vertices(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                              const RasterVertex<Method>& c, TriangleFrame<Method>& frame) {
  frame.top = &a;
  frame.middle = &b;
  frame.bottom = &c;
  order_by_height(frame.top, frame.middle);
  order_by_height(frame.middle, frame.bottom);
  order_by_height(frame.top, frame.middle);
  if constexpr (MeasuresChords<Method>) frame.chords = Method::chords_of(frame);
}

/// The command of a frame whose vertices are placed; false if there is nothing to draw.
template <bool WithDepth, class Method>
[[nodiscard]] constexpr bool prepare_frame(const typename Method::Lighting& lighting,
                                           TriangleFrame<Method>& frame, const typename Method::Face& face,
                                           const RowRange& rows, TriangleCommand<Method>& command) {
  const std::int32_t area = doubled_area(frame.top->position, frame.middle->position, frame.bottom->position);
  if (area == 0 || !place_rows(frame, rows, command)) return false;
  frame.middle_left = area < 0;
  command.middle_left = frame.middle_left;
  place_edges(frame, command);
  if constexpr (WithDepth) {
    make_linear_plane(frame, frame.top->position.z, frame.middle->position.z, frame.bottom->position.z,
                      command.depth);
  } else {
    command.depth = LinearPlane{};
  }
  Method::prepare(lighting, frame, face, command.shade);
  return true;
}

}  // namespace detail

/// Whether any two normals are too far apart for the method.
template <class Method>
[[nodiscard]] constexpr bool is_too_wide(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                         const RasterVertex<Method>& c) {
  return Method::too_wide(a.shade, b.shade) || Method::too_wide(b.shade, c.shade) ||
         Method::too_wide(c.shade, a.shade);
}

namespace detail {

/// The same of a frame whose vertices are placed.
template <class Method>
[[nodiscard]] constexpr bool is_too_wide_in(const TriangleFrame<Method>& frame) {
  if constexpr (MeasuresChords<Method>) {
    return frame.chords.widest() > Method::kWidestChord;
  } else {
    return is_too_wide(*frame.top, *frame.middle, *frame.bottom);
  }
}

}  // namespace detail

/// What became of a triangle.
enum class Preparation : std::uint8_t {
  kReady,    ///< there is a command
  kNothing,  ///< nothing of it is to be drawn
  kTooWide,  ///< two of its normals are too far apart for the method; it is to be split
};

/// Inside the guard band, +-1024 pixels, in which edges and areas fit their words.
[[nodiscard]] constexpr bool in_guard_band(const RasterPosition& p) {
  constexpr std::uint32_t kHalf = kGuardBand << Subpixel::kFraction;
  return ((static_cast<std::uint32_t>(p.x) + kHalf) | (static_cast<std::uint32_t>(p.y) + kHalf)) < 2 * kHalf;
}

/// prepare_triangle() for vertices that are known to be inside the guard band, as those from project() are.
/// kTooWide only if the triangle `may_split`; otherwise it is drawn as well as the method can.
/// Where no depth is tested, no plane of it is made.
template <class Method, bool WithDepth = true>
ARCSPAN_OUTLINE_IF_SMALL [[nodiscard]] constexpr Preparation prepare_inside(
    const typename Method::Lighting& lighting, const RasterVertex<Method>& a, const RasterVertex<Method>& b,
    const RasterVertex<Method>& c, const typename Method::Face& face, const RowRange& rows, bool may_split,
    TriangleCommand<Method>& command) {
  TriangleFrame<Method> frame;
  detail::place_vertices(a, b, c, frame);
  if (may_split && detail::is_too_wide_in(frame)) return Preparation::kTooWide;
  return detail::prepare_frame<WithDepth>(lighting, frame, face, rows, command) ? Preparation::kReady
                                                                                : Preparation::kNothing;
}

/// Turns a triangle into the command that draws it. `rows` are the viewport's; false if none of the
/// triangle's rows is among them, if it has no area, or if a vertex is outside the guard band. Either
/// orientation is drawn.
template <class Method>
[[nodiscard]] constexpr bool prepare_triangle(const typename Method::Lighting& lighting,
                                              const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                              const RasterVertex<Method>& c,
                                              const typename Method::Face& face, const RowRange& rows,
                                              TriangleCommand<Method>& command) {
  if (!in_guard_band(a.position) || !in_guard_band(b.position) || !in_guard_band(c.position)) return false;
  TriangleFrame<Method> frame;
  detail::place_vertices(a, b, c, frame);
  return detail::prepare_frame<true>(lighting, frame, face, rows, command);
}

}  // namespace arcspan
