// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/edge.hpp>
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

  static constexpr std::size_t kBatch = 16;  ///< triangles that a band skips at once
  /// The entries that so many triangles take: one each, and behind these one for each full batch.
  template <class Count>
  [[nodiscard]] static constexpr Count entries(Count triangles) {
    return static_cast<Count>(triangles + triangles / Count{kBatch});
  }

  /// The rows of a group are 2 to the power of this, in a picture of `height` rows, 1...2048.
  [[nodiscard]] static constexpr int group_bits(std::int32_t height) {
    int bits = 0;
    while (((height - 1) >> bits) > 254) ++bits;
    return bits;
  }

  /// Those of a triangle that is culled, and of one that is not but covers no row of the picture.
  [[nodiscard]] static constexpr TriangleRows culled() { return {255, 0}; }
  [[nodiscard]] static constexpr TriangleRows between() { return {254, 0}; }
  /// Those of a triangle across a clip plane, which may cover any.
  [[nodiscard]] static constexpr TriangleRows any() { return {0, 255}; }
  friend constexpr bool operator==(const TriangleRows&, const TriangleRows&) = default;
};

namespace detail {

/// Returns the rows of a triangle with these transformed vertices, for a picture of `height` rows in groups
/// of 2^bits.
template <class Method>
[[nodiscard]] ARCSPAN_INLINE inline TriangleRows rows_of(const CachedVertex<Method>& a,
                                                         const CachedVertex<Method>& b,
                                                         const CachedVertex<Method>& c, std::int32_t height,
                                                         int bits, bool two_sided) {
  if (is_culled(a, b, c, two_sided)) return TriangleRows::culled();
  if (!are_inside(a, b, c)) return TriangleRows::any();
  const RasterPosition& p = a.raster.position;
  const RasterPosition& q = b.raster.position;
  const RasterPosition& r = c.raster.position;
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

/// Sets the rows of the batches of `count` triangles.
inline void find_batch_rows(TriangleRows* rows, std::size_t count) {
  TriangleRows* batch = rows + count;
  for (std::size_t i = 0; i + TriangleRows::kBatch <= count;) {
    TriangleRows all = TriangleRows::culled();
    for (const std::size_t end = i + TriangleRows::kBatch; i < end; ++i) {
      if (rows[i].first < all.first) all.first = rows[i].first;
      if (rows[i].last > all.last) all.last = rows[i].last;
    }
    *batch++ = all;
  }
}

/// Sets the entries() of the mesh of `stage`, whose vertices come from `source`.
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
      if (i == count) break;
    }
    const TriangleIndices t = mesh.triangle(i);
    rows[i] = rows_of(source.vertex(stage, t.a), source.vertex(stage, t.b), source.vertex(stage, t.c), height,
                      bits, two_sided);
  }
  find_batch_rows(rows, count);
}

/// The triangles with rows in a band.
class BandTriangles {
 public:
  static constexpr bool kAllInside = false;
  /// `rows` are the entries() of the mesh of `stage`; `band` is not empty.
  template <class Method, class Mesh>
  BandTriangles(const TriangleRows* rows, const VertexStage<Method, Mesh>& stage, const Rect& band)
      : rows_(rows), batches_(rows + stage.mesh().triangle_count()) {
    const int bits = TriangleRows::group_bits(stage.transform().viewport().height);
    first_ = band.top >> bits;
    last_ = (band.bottom - 1) >> bits;
  }
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    constexpr std::size_t kBatch = TriangleRows::kBatch;
    for (std::size_t step = 1; i < count; i += step) {
      step = i % kBatch == 0 && i + kBatch <= count && !reaches(batches_[i / kBatch]) ? kBatch : 1;
      if (step == 1 && reaches(rows_[i])) break;
    }
    return i;
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE bool reaches(const TriangleRows& rows) const {
    return rows.last >= first_ && rows.first <= last_;
  }

  const TriangleRows* rows_;
  const TriangleRows* batches_;
  std::int32_t first_;  ///< groups of rows of the band
  std::int32_t last_;
};

}  // namespace detail

}  // namespace arcspan
