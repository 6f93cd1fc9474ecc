// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// Clips a triangle, shaded as its side `facing`; sets `inside` to the vertices of the rest, of which there
/// are at most ClipPolygon::kCapacity, and returns their number. A function of its own, so that the stack of
/// the stages that follow does not hold the polygons.
template <class Method>
ARCSPAN_COLD_OUTLINE std::size_t clip_triangle(const VertexStage<Method>& stage, const TriangleIndices& t,
                                               Facing facing, RasterVertex<Method>* inside) {
  ClipPolygon<Method> polygon;
  ClipPolygon<Method> spare;
  polygon.count = 0;
  for (const std::uint16_t i : {t.a, t.b, t.c}) {
    ClipVertex<Method>& vertex = polygon.vertices[polygon.count++];
    vertex.position = stage.clip_position(i);
    stage.shade(i, facing, vertex.shade);
  }
  const ClipPolygon<Method>& rest = clip_polygon(polygon, spare, stage.transform().near_w());
  for (std::size_t i = 0; i < rest.count; ++i) {
    place_on_screen(rest.vertices[i].position, stage.transform(), inside[i]);
    inside[i].shade = rest.vertices[i].shade;
  }
  return rest.count;
}

}  // namespace arcspan::detail
