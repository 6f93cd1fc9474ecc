// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/triangle_command.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>
#include <type_traits>

/// The preparation of a triangle: from three vertices on the screen to a TriangleCommand.
namespace arcspan {

/// near/w of a vertex, 29 fraction bits, 0...1.
struct NearOverW {
  std::int32_t value;
};

/// Input vertex of triangle preparation: its position on the screen and the shading method's data.
template <class Method>
struct RasterVertex {
  RasterPosition position;
  typename Method::Vertex shade;
};
/// RasterVertex of a method that NeedsNearOverW.
template <NeedsNearOverW Method>
struct RasterVertex<Method> {
  RasterPosition position;
  typename Method::Vertex shade;
  NearOverW near_over_w;
};

namespace detail {

/// Sets where a vertex inside the clip volume is on the screen.
template <class Method>
ARCSPAN_INLINE inline void place_on_screen(const ClipPosition& position, const ClipTransform& transform,
                                           RasterVertex<Method>& vertex) {
  [[maybe_unused]] const std::int32_t near_over_w =
      project_to(position.x, position.y, position.w, transform, vertex.position);
  if constexpr (NeedsNearOverW<Method>) vertex.near_over_w.value = near_over_w;
}

/// A copy of a vertex without its shading.
template <class Method>
[[nodiscard]] constexpr RasterVertex<Method> unshaded(const RasterVertex<Method>& vertex) {
  RasterVertex<Method> copy{};
  copy.position = vertex.position;
  if constexpr (NeedsNearOverW<Method>) copy.near_over_w = vertex.near_over_w;
  return copy;
}

}  // namespace detail

/// The rows to be drawn of a viewport, first ... end - 1, relative to the raster origin.
struct RowRange {
  std::int32_t first = 0;
  std::int32_t end = 0;
};

/// Returns twice the signed area in 256ths of a square pixel. It is negative if a, b, c run counter-clockwise
/// as seen on the screen (y down), as those of front faces do. The result is exact inside the guard band,
/// where it fits 32 bits.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t doubled_area(const RasterPosition& a,
                                                                 const RasterPosition& b,
                                                                 const RasterPosition& c) {
  return wrap_sub(wrap_mul(b.x - a.x, c.y - a.y), wrap_mul(c.x - a.x, b.y - a.y));
}

/// The vertices of a triangle with an area, from the highest to the lowest. Small and large triangles begin
/// with them, so that a triangle is sorted once however it is drawn.
template <class Method>
struct SortedVertices {
  const RasterVertex<Method>* top;
  const RasterVertex<Method>* middle;
  const RasterVertex<Method>* bottom;
  bool middle_left;  ///< the middle vertex is on the left of the long edge
};

namespace detail {

/// Swaps two vertices if `lower` is the higher one. That turns the triangle over, and so `middle_left`.
template <class Method>
ARCSPAN_INLINE constexpr void order_by_height(const RasterVertex<Method>*& upper,
                                              const RasterVertex<Method>*& lower, bool& middle_left) {
  if (lower->position.y < upper->position.y) {
    const RasterVertex<Method>* const held = upper;
    upper = lower;
    lower = held;
    middle_left = !middle_left;
  }
}

/// Sorts three vertices. On entry: `middle_left` is true if doubled_area() of top, middle and bottom is
/// negative; on return: if the middle vertex is on the left of the long edge.
template <class Method>
ARCSPAN_OUTLINE_IF_TIGHT constexpr void sort_by_height(SortedVertices<Method>& vertices) {
  const RasterVertex<Method>* top = vertices.top;
  const RasterVertex<Method>* middle = vertices.middle;
  const RasterVertex<Method>* bottom = vertices.bottom;
  bool middle_left = vertices.middle_left;
  order_by_height<Method>(top, middle, middle_left);
  order_by_height<Method>(middle, bottom, middle_left);
  order_by_height<Method>(top, middle, middle_left);
  vertices.top = top;
  vertices.middle = middle;
  vertices.bottom = bottom;
  vertices.middle_left = middle_left;
}

}  // namespace detail

/// The geometry of a triangle from which preparation sets up attributes: the vertices and the three edges.
template <class Method>
struct TriangleFrame : SortedVertices<Method> {
  struct NoWalk {};

  EdgeSetup long_edge;
  EdgeSetup upper_edge;
  EdgeSetup lower_edge;
  bool has_upper;           ///< the upper half has rows to draw; otherwise upper_edge is unset
  bool has_lower;           ///< the lower half has rows to draw; otherwise lower_edge is unset
  Factor middle_fraction;   ///< fraction of the long edge at the middle vertex's height
  std::uint32_t width;      ///< width in pixels at that height, 16 fraction bits, raw value at least 1
  Reciprocal inverse_unit;  ///< reciprocal of the SlopeUnit, 16 fraction bits
  /// The long edge at its first row, for methods that NeedsNearOverW.
  [[no_unique_address]] std::conditional_t<NeedsNearOverW<Method>, EdgeWalk, NoWalk> long_walk;
};

/// Sets up the plane of a 16-bit attribute from its values at the top, middle and bottom vertex.
template <class Value, class Method>
constexpr void make_linear_plane(const TriangleFrame<Method>& frame, std::int32_t top, std::int32_t middle,
                                 std::int32_t bottom, BasicLinearPlane<Value>& plane) {
  plane.dx = gradient_across<Value>(frame, top, middle, bottom);
  // Edges without rows are zeroed, so that commands compare equal.
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

/// Sets the rows of the command, clamped to `rows`. Returns false if there are none.
template <class Method>
[[nodiscard]] constexpr bool place_rows(const TriangleFrame<Method>& frame, const RowRange& rows,
                                        TriangleCommand<Method>& command) {
  std::int32_t first = first_row_at(frame.top->position.y);
  std::int32_t middle = first_row_at(frame.middle->position.y);
  std::int32_t end = first_row_at(frame.bottom->position.y);
  if (first < rows.first || end > rows.end) [[unlikely]] {
    const auto clamped = [&rows](std::int32_t row) {
      return row < rows.first ? rows.first : row > rows.end ? rows.end : row;
    };
    first = clamped(first);
    middle = clamped(middle);
    end = clamped(end);
  }
  command.first_row = static_cast<std::int16_t>(first);
  command.middle_row = static_cast<std::int16_t>(middle);
  command.end_row = static_cast<std::int16_t>(end);
  return first < end;
}

/// Sets up the edges that have rows to draw, and the width of the triangle at its middle vertex.
template <class Method>
constexpr void place_edges(TriangleFrame<Method>& frame, TriangleCommand<Method>& command) {
  const RasterPosition& top = frame.top->position;
  const RasterPosition& middle = frame.middle->position;
  const RasterPosition& bottom = frame.bottom->position;
  frame.has_upper = command.first_row < command.middle_row;
  frame.has_lower = command.middle_row < command.end_row;
  EdgeWalk& long_walk = frame.middle_left ? command.right : command.left;
  make_edge_setup(top, bottom, command.first_row, frame.long_edge);
  make_edge_walk(frame.long_edge, top, bottom, long_walk);
  if constexpr (NeedsNearOverW<Method>) frame.long_walk = long_walk;
  // Edges are moved with the picture whether rows use them or not, so that one without rows is set, too.
  if (frame.has_upper) [[likely]] {
    make_edge_setup(top, middle, command.first_row, frame.upper_edge);
    make_edge_walk(frame.upper_edge, top, middle, frame.middle_left ? command.left : command.right);
  } else {
    frame.upper_edge.offset = 0;  // unused, but gcc would warn
    (frame.middle_left ? command.left : command.right).x = 0;
  }
  if (frame.has_lower) [[likely]] {
    make_edge_setup(middle, bottom, command.middle_row, frame.lower_edge);
    make_edge_walk(frame.lower_edge, middle, bottom, command.lower);
  } else {
    frame.lower_edge.offset = 0;
    command.lower.x = 0;
  }
  const auto height = static_cast<std::uint32_t>(middle.y - top.y);
  frame.middle_fraction =
      Factor::from_raw(static_cast<std::int32_t>(frame.long_edge.inverse.times(height, Factor::kFraction)));
  // In 16ths of a pixel with 32 fraction bits; the product rounded down to whole pixels with 32.
  const std::int64_t across =
      (std::int64_t{middle.x - top.x} << 32) - (scaled(long_walk.step, height) & ~std::int64_t{15});
  const std::int64_t width = (across < 0 ? -across : across) >> 4;  // 32 fraction bits
  frame.width = width < 0x10000 ? 1u : static_cast<std::uint32_t>(width >> 16);
  const bool is_sliver = (width >> 32) == 0;
  const Reciprocal inverse = nonzero_reciprocal(is_sliver ? static_cast<std::uint32_t>(width) : frame.width);
  command.unit = {is_sliver, static_cast<std::uint8_t>(inverse.exponent), inverse.mantissa};
  frame.inverse_unit = is_sliver ? Reciprocal{std::uint32_t{1} << 16, 32} : inverse;
}

}  // namespace detail

/// Makes the command of a triangle whose vertices are sorted. Returns false if it has no row among `rows`.
template <class Method, bool WithDepth>
ARCSPAN_OUTLINE_IF_TIGHT [[nodiscard]] constexpr bool prepare_sorted(
    const typename Method::Lighting& lighting, const SortedVertices<Method>& vertices,
    const typename Method::Face& face, const RowRange& rows, TriangleCommand<Method>& command) {
  TriangleFrame<Method> frame;
  static_cast<SortedVertices<Method>&>(frame) = vertices;
  if (!detail::place_rows(frame, rows, command)) return false;
  command.middle_left = frame.middle_left;
  detail::place_edges(frame, command);
  if constexpr (WithDepth) {
    make_linear_plane(frame, frame.top->position.z, frame.middle->position.z, frame.bottom->position.z,
                      command.depth);
  } else {
    command.depth = LinearPlane{};
  }
  Method::prepare(lighting, frame, face, command.shade);
  return true;
}

/// Returns true inside the guard band, [-1024, 1024) pixels, within which edges and areas fit their words.
[[nodiscard]] constexpr bool in_guard_band(const RasterPosition& p) {
  constexpr std::uint32_t kHalf = kGuardBand << Subpixel::kFraction;
  return ((static_cast<std::uint32_t>(p.x) + kHalf) | (static_cast<std::uint32_t>(p.y) + kHalf)) < 2 * kHalf;
}

/// Makes the command that draws a triangle of either winding. Returns false if there is nothing to draw: if
/// the triangle has no row among `rows`, the rows of the viewport, if it has no area, or if a vertex is
/// outside the guard band. `WithDepth` is false where depth is not tested; the depth plane is then zero.
template <class Method, bool WithDepth = true>
[[nodiscard]] constexpr bool prepare_triangle(const typename Method::Lighting& lighting,
                                              const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                              const RasterVertex<Method>& c,
                                              const typename Method::Face& face, const RowRange& rows,
                                              TriangleCommand<Method>& command) {
  if (!in_guard_band(a.position) || !in_guard_band(b.position) || !in_guard_band(c.position)) return false;
  const std::int32_t area = doubled_area(a.position, b.position, c.position);
  if (area == 0) return false;
  SortedVertices<Method> vertices{&a, &b, &c, area < 0};
  detail::sort_by_height(vertices);
  return prepare_sorted<Method, WithDepth>(lighting, vertices, face, rows, command);
}

}  // namespace arcspan
