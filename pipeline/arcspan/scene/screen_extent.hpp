// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// The least and the largest coordinates of vertices on the screen, in sixteenths of a pixel from the raster
/// origin.
struct ScreenExtent {
  std::int32_t left = INT32_MAX;
  std::int32_t top = INT32_MAX;
  std::int32_t right = INT32_MIN;
  std::int32_t bottom = INT32_MIN;

  constexpr void include(const RasterPosition& p) {
    if (p.x < left) left = p.x;
    if (p.x > right) right = p.x;
    if (p.y < top) top = p.y;
    if (p.y > bottom) bottom = p.y;
  }
};

/// How the triangles of an extent are drawn.
struct ExtentOptions {
  bool two_sided;
  bool clips;  ///< triangles across the near plane or the guard band are drawn
  bool edges;  ///< their edges are, not their areas (DrawsEdges)
};

/// Includes what is drawn of a triangle that has to be clipped.
void include_clipped(const MeshView& mesh, const ClipTransform& transform, const TriangleIndices& t,
                     const ExtentOptions& options, ScreenExtent& extent);

/// Returns the pixels that triangles or lines within `extent` may have, as far as they are in the picture:
/// those whose centres lie in it, or that contain a point of it if `edges`. Rect{} if there are none.
[[nodiscard]] Rect pixels_of(const ScreenExtent& extent, bool edges, const Viewport& viewport);

/// Includes the vertices of all triangles that the draw call of `stage` would not cull, with the vertices of
/// a VertexSource.
template <class Method, class Source>
void include_triangles(const VertexStage<Method>& stage, Source& source, const ExtentOptions& options,
                       ScreenExtent& all) {
  const MeshView& mesh = stage.mesh();
  const BackFaces& back_faces = stage.back_faces();
  const std::size_t count = mesh.triangle_count();
  ScreenExtent extent = all;
  for (std::size_t i = 0; i < count; ++i) {
    if (back_faces.known()) {
      i = back_faces.next_front(i, count);
      if (i == count) break;
    }
    const TriangleIndices t = mesh.triangle(i);
    const auto& a = source.vertex(stage, t.a);
    const auto& b = source.vertex(stage, t.b);
    const auto& c = source.vertex(stage, t.c);
    if ((a.outcode | b.outcode | c.outcode) != 0) {
      if ((a.outcode & b.outcode & c.outcode) == 0 && options.clips)
        include_clipped(mesh, stage.transform(), t, options, extent);
      continue;
    }
    const RasterPosition& p = a.raster.position;
    const RasterPosition& q = b.raster.position;
    const RasterPosition& r = c.raster.position;
    if (is_culled_by_area<Method>(doubled_area(p, q, r), options.two_sided)) continue;
    extent.include(p);
    extent.include(q);
    extent.include(r);
  }
  all = extent;
}

}  // namespace arcspan::detail
