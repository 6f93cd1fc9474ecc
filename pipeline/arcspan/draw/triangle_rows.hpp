// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/line_command.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

/// The rows of triangles, by which a picture in bands skips those of other bands.
namespace arcspan {

/// The rows of a triangle, in groups from the top of the picture: first ... last. A picture of up to 255 rows
/// has groups of one row, a higher one of 2, 4, 8 or 16, so that there are at most 255.
struct TriangleRows {
  std::uint8_t first;
  std::uint8_t last;  ///< below `first` if the triangle has no rows

  /// The rows of a group are 2 to the power of this, in a picture of `height` rows, 1...2048.
  [[nodiscard]] static constexpr int group_bits(std::int32_t height) {
    int bits = 0;
    while (((height - 1) >> bits) > 254) ++bits;
    return bits;
  }

  /// Those of a triangle that is culled, and of one that is not but covers no row of the picture.
  [[nodiscard]] static constexpr TriangleRows culled() { return {255, 0}; }
  [[nodiscard]] static constexpr TriangleRows between() { return {254, 0}; }
  /// Those of a triangle across the near plane or the guard band, which may cover any.
  [[nodiscard]] static constexpr TriangleRows any() { return {0, 255}; }
  friend constexpr bool operator==(const TriangleRows&, const TriangleRows&) = default;
};

namespace detail {

/// Returns the rows of a triangle with these transformed vertices, for a picture of `height` rows in groups
/// of 2^bits.
template <class Method>
[[nodiscard]] TriangleRows rows_of(const CachedVertex<Method>& a, const CachedVertex<Method>& b,
                                   const CachedVertex<Method>& c, std::int32_t height, int bits,
                                   bool two_sided) {
  if ((a.outcode | b.outcode | c.outcode) != 0) {
    return (a.outcode & b.outcode & c.outcode) != 0 ? TriangleRows::culled() : TriangleRows::any();
  }
  const RasterPosition& p = a.raster.position;
  const RasterPosition& q = b.raster.position;
  const RasterPosition& r = c.raster.position;
  if (is_culled_by_area<Method>(doubled_area(p, q, r), two_sided)) return TriangleRows::culled();
  const std::int32_t upper = p.y < q.y ? p.y : q.y;
  const std::int32_t lower = p.y > q.y ? p.y : q.y;
  const std::int32_t uppermost = upper < r.y ? upper : r.y;
  const std::int32_t lowest = lower > r.y ? lower : r.y;
  // A line has pixels wherever it runs, a triangle where it covers their centres.
  const std::int32_t top =
      (DrawsEdges<Method> ? pixel_of(uppermost) : first_row_at(uppermost)) + (height >> 1);
  const std::int32_t end = (DrawsEdges<Method> ? pixel_of(lowest) + 1 : first_row_at(lowest)) + (height >> 1);
  if (top >= end || end <= 0 || top >= height) return TriangleRows::between();
  const auto group = [bits](std::int32_t row) { return static_cast<std::uint8_t>(row >> bits); };
  return {group(top < 0 ? 0 : top), group((end > height ? height : end) - 1)};
}

/// Sets the rows of all triangles of the mesh of `stage`, whose vertices come from `source`.
template <class Method, class Mesh, class Source>
void find_rows(const VertexStage<Method, Mesh>& stage, bool two_sided, Source& source, TriangleRows* rows) {
  const MeshView& mesh = stage.mesh();
  const BackFaces& back_faces = stage.back_faces();
  const std::size_t count = mesh.triangle_count();
  const std::int32_t height = stage.transform().viewport().height;
  const int bits = TriangleRows::group_bits(height);
  for (std::size_t i = 0; i < count; ++i) {
    if (back_faces.known()) {
      const std::size_t front = back_faces.next_front(i, count);
      for (; i < front; ++i) rows[i] = TriangleRows::culled();
      if (i == count) return;
    }
    const TriangleIndices t = mesh.triangle(i);
    rows[i] = rows_of(source.vertex(stage, t.a), source.vertex(stage, t.b), source.vertex(stage, t.c), height,
                      bits, two_sided);
  }
}

/// The triangles with rows in a band.
class BandTriangles {
 public:
  static constexpr bool kAllInside = false;
  /// `rows` are those of all triangles of the mesh in a picture of `height` rows; `band` is not empty.
  constexpr BandTriangles(const TriangleRows* rows, const Rect& band, std::int32_t height)
      : rows_(rows),
        first_(band.top >> TriangleRows::group_bits(height)),
        last_((band.bottom - 1) >> TriangleRows::group_bits(height)) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    while (i < count && (rows_[i].last < first_ || rows_[i].first > last_)) ++i;
    return i;
  }

 private:
  const TriangleRows* rows_;
  std::int32_t first_;  ///< groups of rows of the band
  std::int32_t last_;
};

}  // namespace detail

}  // namespace arcspan
