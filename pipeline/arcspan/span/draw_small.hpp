// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/span/draw_pixels.hpp>
#include <arcspan/span/row_drawer.hpp>
#include <arcspan/span/row_memory.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Draws the pixels of a small triangle. `surface` gives the runs of its rows.
template <class Surface, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_small_pixels(const SmallTriangle& triangle,
                                                                 const Surface& surface,
                                                                 const RasterOrigin& origin,
                                                                 const Target& all) {
  constexpr bool kFromFirstColumn = SinkFromFirstColumn<typename Target::Sink>;
  const Target target = all;  // a copy, because the members of a reference would be loaded for every pixel
  const std::int32_t first_y = triangle.row + origin.y;
  const RowMemory<Target> memory(target, first_y);
  const std::int32_t rows = triangle.rows;
  const std::int32_t origin_x = origin.x;
  for (std::int32_t row = 0; row < rows; ++row) {
    hide_value(row);
    const SmallSpan found = triangle.spans[row];
    const bool is_hidden = found.count == 0;
    if (is_hidden && (kFromFirstColumn || !target.crosses || triangle.cut_counts[row] == 0)) continue;
    Span span{first_y + row, found.first + origin_x, found.count};
    const std::int32_t b = triangle.coordinate(triangle.of_middle(found.first, row));
    const std::int32_t c = triangle.coordinate(triangle.of_bottom(found.first, row));
    auto run = surface.row((triangle.row + row) * 16 + 8, b, c);
    Linear z = triangle.depth(b, c);
    if (!kFromFirstColumn && is_hidden) [[unlikely]] {
      for (; span.x < target.scissor.left; ++span.x, z += triangle.dz) run.next();
      span.count = triangle.cut_counts[row];
    }
    const Status status = draw_span(span, run, z, triangle.dz, target, memory, row);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

/// How drawing a small triangle ended.
enum class SmallResult : std::uint8_t {
  kDone,       ///< drawn, as far as it has pixels
  kOutOfView,  ///< it has no row in the viewport
  kRefused     ///< nothing is drawn, because the method needs a TriangleCommand for its normals
};

/// Cuts a small triangle to the columns of the scissor, so that its rows start at their first columns in the
/// picture. Returns false if no pixel is left.
template <class Target>
[[nodiscard]] constexpr bool cut_small_triangle(const Target& target, const RasterOrigin& origin,
                                                SmallTriangle& triangle) {
  const std::int32_t left = target.scissor.left;
  const std::int32_t right = target.scissor.right;
  if constexpr (SinkFromFirstColumn<typename Target::Sink>) {
    return cut_columns(left - origin.x, right - origin.x, triangle);
  } else {
    if (!cut_columns((left < 0 ? left : 0) - origin.x, right - origin.x, triangle)) return false;
    hide_columns(left - origin.x, triangle);
    return true;
  }
}

/// Draws a small triangle (is_small()) of either winding, whose Method::Face face_of() returns. `rows` are
/// those of the viewport, `drawn` those of the scissor. Sets `status` if the result is kDone.
template <class Method, class Target, class FaceOf>
[[nodiscard]] ARCSPAN_INLINE constexpr SmallResult draw_small_triangle(
    const SortedVertices<Method>& vertices, const FaceOf& face_of, const RowRange& rows,
    const RowRange& drawn, const RasterOrigin& origin, const Target& target, Status& status) {
  const RasterPosition& p = vertices.top->position;
  const RasterPosition& q = vertices.middle->position;
  const RasterPosition& r = vertices.bottom->position;
  SmallTriangle triangle;
  if (!cover_small_triangle(p, q, r, vertices.middle_left, drawn, triangle) ||
      (target.crosses && !cut_small_triangle(target, origin, triangle))) {
    const std::int32_t first = first_row_at(p.y);
    const std::int32_t end = first_row_at(r.y);
    status = Status::kOk;
    return (first > rows.first ? first : rows.first) < (end < rows.end ? end : rows.end)
               ? SmallResult::kDone
               : SmallResult::kOutOfView;
  }
  prepare_small_triangle(p, q, r, triangle);
  typename Method::Small part;
  if (!Method::prepare_small(target.lighting, *vertices.top, *vertices.middle, *vertices.bottom, face_of(),
                             triangle, part)) {
    return SmallResult::kRefused;
  }
  status = Method::walk_small(
      part, [&](const auto& surface) { return draw_small_pixels(triangle, surface, origin, target); });
  return SmallResult::kDone;
}

}  // namespace arcspan::detail
