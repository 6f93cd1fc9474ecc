// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/line_command.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The rows of a triangle, in groups of 8 from the top of the picture: first ... last.
struct TriangleRows {
  static constexpr int kGroupBits = 3;

  std::uint8_t first;
  std::uint8_t last;  ///< below `first` if the triangle is not drawn
};

namespace detail {

inline constexpr TriangleRows kNoTriangleRows{255, 0};

/// The groups of a triangle with these vertices, for a picture of `height` rows.
template <class Method>
[[nodiscard]] TriangleRows rows_of(const CachedVertex<Method>& a, const CachedVertex<Method>& b,
                                   const CachedVertex<Method>& c, std::int32_t height, bool two_sided) {
  if ((a.outcode | b.outcode | c.outcode) != 0) {
    return (a.outcode & b.outcode & c.outcode) != 0 ? kNoTriangleRows : TriangleRows{0, 255};
  }
  const RasterPosition& p = a.raster.position;
  const RasterPosition& q = b.raster.position;
  const RasterPosition& r = c.raster.position;
  if (is_culled_by_area<Method>(doubled_area(p, q, r), two_sided)) return kNoTriangleRows;
  const std::int32_t upper = p.y < q.y ? p.y : q.y;
  const std::int32_t lower = p.y > q.y ? p.y : q.y;
  const std::int32_t uppermost = upper < r.y ? upper : r.y;
  const std::int32_t lowest = lower > r.y ? lower : r.y;
  // A line has pixels wherever it runs, a triangle where it covers their centres.
  const std::int32_t top =
      (DrawsEdges<Method> ? pixel_of(uppermost) : first_row_at(uppermost)) + (height >> 1);
  const std::int32_t end = (DrawsEdges<Method> ? pixel_of(lowest) + 1 : first_row_at(lowest)) + (height >> 1);
  if (top >= end || end <= 0 || top >= height) return kNoTriangleRows;
  const auto group = [](std::int32_t row) {
    return static_cast<std::uint8_t>(row >> TriangleRows::kGroupBits);
  };
  return {group(top < 0 ? 0 : top), group((end > height ? height : end) - 1)};
}

/// Sets the rows of all triangles of a mesh; `vertices` are transformed as they are needed.
template <class Method>
void find_rows(const VertexStage<Method>& stage, bool two_sided, CachedVertex<Method>* vertices,
               TriangleRows* rows) {
  const MeshView& mesh = stage.mesh();
  const BackFaces back_faces = two_sided ? BackFaces() : BackFaces(mesh, stage.transform());
  const std::int32_t height = stage.transform().viewport().height;
  const std::size_t count = mesh.triangle_count();
  for (std::size_t i = 0; i < count; ++i) {
    if (back_faces.known()) {
      const std::size_t front = back_faces.next_front(i, count);
      for (; i < front; ++i) rows[i] = kNoTriangleRows;
      if (i == count) return;
    }
    const TriangleIndices t = mesh.triangle(i);
    for (const std::uint16_t v : {t.a, t.b, t.c}) stage.transform_if_needed(v, vertices[v]);
    rows[i] = rows_of(vertices[t.a], vertices[t.b], vertices[t.c], height, two_sided);
  }
}

}  // namespace detail
}  // namespace arcspan
