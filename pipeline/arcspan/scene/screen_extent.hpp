// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan::detail {

/// The rectangle around vertices on the screen, in sixteenths of a pixel from the raster origin: from (left,
/// top) to (left + width, top + height). At first it is far outside of the guard band.
struct ScreenExtent {
  static constexpr std::int32_t kNowhere = -(std::int32_t{1} << 20);

  std::int32_t left = kNowhere;
  std::int32_t top = kNowhere;
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  [[nodiscard]] constexpr bool empty() const { return left == kNowhere; }
  [[nodiscard]] constexpr std::int32_t right() const { return left + static_cast<std::int32_t>(width); }
  [[nodiscard]] constexpr std::int32_t bottom() const { return top + static_cast<std::int32_t>(height); }
  [[nodiscard]] ARCSPAN_INLINE constexpr bool contains(const RasterPosition& p) const {
    return static_cast<std::uint32_t>(p.x - left) <= width && static_cast<std::uint32_t>(p.y - top) <= height;
  }
};

/// The rectangle around an extent and a vertex.
[[nodiscard]] ScreenExtent extended(const ScreenExtent& extent, const RasterPosition& p);

/// Whether a triangle has no pixel in the picture because it lies beside it.
[[nodiscard]] bool is_beside_picture(const RasterPosition& a, const RasterPosition& b,
                                     const RasterPosition& c, const Viewport& viewport);

/// How the triangles of an extent are drawn.
struct ExtentOptions {
  bool two_sided;
  bool clips;  ///< triangles across a clip plane are drawn
  bool edges;  ///< their edges are, not their areas (DrawsEdges)
};

/// The rectangle around an extent and what is drawn of a triangle that has to be clipped.
[[nodiscard]] ScreenExtent extended_by_clipped(const MeshView& mesh, const ClipTransform& transform,
                                               const TriangleIndices& t, const ExtentOptions& options,
                                               const ScreenExtent& extent);

/// The same for a mesh that poses its vertices: of a mesh of this triangle alone, whose vertices have the
/// order that they have in the whole one, because clipping depends on it.
template <DrawableMesh Mesh>
[[nodiscard]] ScreenExtent extended_by_clipped_pose(const Mesh& mesh, const ClipTransform& transform,
                                                    const TriangleIndices& t, const ExtentOptions& options,
                                                    const ScreenExtent& extent) {
  const std::uint16_t all[] = {t.a, t.b, t.c};
  ObjectPosition positions[3];
  const PackedNormal normals[3] = {};
  std::uint8_t order[3];
  for (std::size_t i = 0; i < 3; ++i) {
    order[i] = 0;
    for (const std::uint16_t other : all) order[i] = static_cast<std::uint8_t>(order[i] + (all[i] > other));
    positions[order[i]] = mesh.position(all[i]);
  }
  MeshView triangle;
  (void)MeshView::make(positions, normals, order, triangle);
  return extended_by_clipped(triangle, transform, triangle.triangle(0), options, extent);
}

/// Returns the pixels that triangles or lines within `extent` may have, as far as they are in the picture:
/// those whose centres lie in it, or that contain a point of it if `edges`. Rect{} if there are none.
[[nodiscard]] Rect pixels_of(const ScreenExtent& extent, bool edges, const Viewport& viewport);

/// Includes the vertices of the triangles of `filter` (draw/triangle_drawer.hpp) that are neither culled nor
/// beside the picture.
template <class Method, class Mesh, class Source, class Filter>
ARCSPAN_OUTLINE void include_triangles(const VertexStage<Method, Mesh>& stage, Source& source,
                                       const ExtentOptions& options, const Filter& filter,
                                       ScreenExtent& all) {
  const MeshView& mesh = stage.mesh();
  const std::size_t count = mesh.triangle_count();
  const bool two_sided = options.two_sided;
  ScreenExtent extent = all;
  for (std::size_t i = filter.next(0, count); i < count; i = filter.next(i + 1, count)) {
    const TriangleIndices t = mesh.triangle(i);
    const auto& a = source.vertex(stage, t.a);
    const auto& b = source.vertex(stage, t.b);
    const auto& c = source.vertex(stage, t.c);
    if constexpr (!Filter::kAllInside) {
      if ((a.outcode | b.outcode | c.outcode) != 0) {
        if ((a.outcode & b.outcode & c.outcode) == 0 && options.clips) {
          if constexpr (std::is_same_v<Mesh, MeshView>) {
            extent = extended_by_clipped(mesh, stage.transform(), t, options, extent);
          } else {
            extent = extended_by_clipped_pose(stage.posed(), stage.transform(), t, options, extent);
          }
        }
        continue;
      }
    }
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    // Few triangles reach farther than those before them.
    if (extent.contains(p) && extent.contains(q) && extent.contains(r)) [[likely]]
      continue;
    if (is_culled_by_area<Method>(doubled_area(p, q, r), two_sided)) continue;
    if (is_beside_picture(p, q, r, stage.transform().viewport())) continue;
    extent = extended(extended(extended(extent, p), q), r);
  }
  all = extent;
}

/// Includes the vertices of all triangles that the draw call of `stage` would not cull, with the vertices of
/// a VertexSource.
template <class Method, class Mesh, class Source>
void include_triangles(const VertexStage<Method, Mesh>& stage, Source& source, const ExtentOptions& options,
                       ScreenExtent& extent) {
  if (stage.back_faces().known()) {
    include_triangles(stage, source, options, FrontTriangles{stage.back_faces()}, extent);
  } else {
    include_triangles(stage, source, options, AllTriangles{}, extent);
  }
}

}  // namespace arcspan::detail
