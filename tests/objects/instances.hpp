// SPDX-License-Identifier: MIT
// Explicit instances of the pipeline's templates, made by macros.
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/span/draw_command.hpp>

namespace arcspan {

// draw_mesh() as a whole.
#define ARCSPAN_MESH_INSTANTIATE(METHOD, FORMAT, DEPTH)                                          \
  template DrawResult draw_mesh<METHOD, DrawFeatures{}, hal::Framebuffer<FORMAT>, DEPTH>(        \
      const MeshView&, const ClipTransform&, const METHOD::Lighting&, hal::Framebuffer<FORMAT>&, \
      const DEPTH&, std::span<CachedVertex<METHOD>>, const DrawOptions&)

// The span stage.
#define ARCSPAN_SPAN_INSTANTIATE(METHOD, FORMAT, DEPTH)                                    \
  template Status draw_command<METHOD, hal::Framebuffer<FORMAT>, DEPTH>(                   \
      TriangleCommand<METHOD>&, const RasterOrigin&, const Rect&, const METHOD::Lighting&, \
      hal::Framebuffer<FORMAT>&, const DEPTH&)

/// Vertices are made, an edge is cut, and the triangle is prepared as a large one and as a small one.
template <class Method>
bool prepare(const MeshView& mesh, const typename Method::Lighting& lighting, const Direction& face,
             const RowRange& rows, SmallTriangle& small, TriangleCommand<Method>& command) {
  RasterVertex<Method> v[3];
  for (std::size_t i = 0; i < 3; ++i) {
    v[i].position = {mesh.position(i).x, mesh.position(i).y, 0};
    v[i].shade = Method::shade_vertex(lighting, unpack_normal(mesh.normal(i)));
    if constexpr (TakesVertexData<Method>) Method::set_vertex_data(mesh, i, v[i].shade);
  }
  v[2].shade = Method::between(v[1].shade, v[2].shade, CutFraction{face.x.raw()});
  if constexpr (DrawsSmallTriangles<Method>) {
    typename Method::Small part;
    if (Method::prepare_small(lighting, v[0], v[1], v[2], Method::shade_face(lighting, face), small, part))
      return true;
  }
  return prepare_triangle(lighting, v[0], v[1], v[2], Method::shade_face(lighting, face), rows, command);
}

#define ARCSPAN_PREPARE_INSTANTIATE(METHOD)                                                          \
  template bool prepare(const MeshView&, const METHOD::Lighting&, const Direction&, const RowRange&, \
                        SmallTriangle&, TriangleCommand<METHOD>&)

}  // namespace arcspan
