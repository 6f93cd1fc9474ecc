// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/line_command.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The rows of a triangle, in groups of 8 from the top of the picture: first ... last.
struct TriangleRows {
  static constexpr int kGroupBits = 3;

  std::uint8_t first;
  std::uint8_t last;  ///< below `first` if the triangle is not drawn
};

/// Which triangles of a mesh a draw call looks at. A filter has next(i, count), the first triangle from i on
/// that may be visible (`count` if there is none), and kAllInside, true if all vertices are known to be
/// inside the clip volume and backs are known not to be drawn.
namespace detail {

/// All triangles.
struct AllTriangles {
  static constexpr bool kAllInside = false;
  [[nodiscard]] constexpr std::size_t next(std::size_t i, std::size_t) const { return i; }
};

/// The triangles that may be front faces, where the planes of the faces tell (BackFaces::known()).
struct FrontTriangles {
  static constexpr bool kAllInside = true;
  const BackFaces& back_faces;
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return back_faces.next_front(i, count);
  }
};

/// The triangles with rows in a band.
class BandTriangles {
 public:
  static constexpr bool kAllInside = false;
  /// `rows` are those of all triangles of the mesh; `band` is not empty.
  constexpr BandTriangles(const TriangleRows* rows, const Rect& band)
      : rows_(rows),
        first_(band.top >> TriangleRows::kGroupBits),
        last_((band.bottom - 1) >> TriangleRows::kGroupBits) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    while (i < count && (rows_[i].last < first_ || rows_[i].first > last_)) ++i;
    return i;
  }

 private:
  const TriangleRows* rows_;
  std::int32_t first_;  ///< groups of rows of the band
  std::int32_t last_;
};

/// True if a triangle of this doubled_area() is not drawn: it shows its back, and backs are not drawn, or it
/// has no area, and no edges are drawn.
template <class Method>
[[nodiscard]] ARCSPAN_INLINE constexpr bool is_culled_by_area(std::int32_t doubled, bool two_sided) {
  return doubled >= 0 && ((doubled == 0 && !DrawsEdges<Method>) || !two_sided);
}

inline constexpr TriangleRows kNoTriangleRows{255, 0};

/// Returns the rows of a triangle with these transformed vertices, for a picture of `height` rows.
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

}  // namespace detail
}  // namespace arcspan
