// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/line_stage.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// Draws the edges of triangles as lines (DrawsEdges).
template <class Method, class Target, class Mesh>
struct EdgeDrawer {
  const VertexStage<Method, Mesh>& stage;
  const Scissor& scissor;
  const Target& target;
  bool two_sided;
  DrawResult& result;
  bool& drawn;  ///< set if an edge has pixels in the scissor

  /// Draws the edges of a triangle that is not culled.
  template <bool Clips, class Vertex>
  void draw(const TriangleIndices& t, const Vertex& a, const Vertex& b, const Vertex& c) const {
    if ((a.outcode | b.outcode | c.outcode) == 0) {
      draw_edge(a.raster.position, b.raster.position);
      draw_edge(b.raster.position, c.raster.position);
      draw_edge(c.raster.position, a.raster.position);
    } else if constexpr (Clips) {
      draw_clipped(t);
    } else {
      ++result.left_out;
    }
  }

 private:
  /// Draws the edges of a triangle across the near plane or the guard band. The sides along these planes are
  /// no edges.
  ARCSPAN_OUTLINE ARCSPAN_COLD void draw_clipped(const TriangleIndices& t) const {
    if (!two_sided && !shows_front(t)) return;
    const std::uint16_t ends[] = {t.a, t.b, t.c, t.a};
    for (std::size_t i = 0; i < 3; ++i) {
      RasterPosition a;
      RasterPosition b;
      if (clip_line(stage.transform(), stage.clip_position(ends[i]), stage.clip_position(ends[i + 1]), a,
                    b)) {
        draw_edge(a, b);
      }
    }
  }

  ARCSPAN_OUTLINE void draw_edge(const RasterPosition& a, const RasterPosition& b) const {
    if (!ok(result.status) || !has_pixels(scissor, a, b)) return;
    drawn = true;
    result.status = draw_line_between<Method>(a, b, stage.lighting().bias.units, scissor.origin(), target);
  }

  /// True if what is left of a triangle after clipping shows its front.
  [[nodiscard]] bool shows_front(const TriangleIndices& t) const {
    RasterVertex<Method> inside[ClipPolygon<Method>::kCapacity];
    const std::size_t count = clip_triangle(stage, t, Facing::kFront, inside);
    for (std::size_t i = 2; i < count; ++i) {
      if (doubled_area(inside[0].position, inside[i - 1].position, inside[i].position) < 0) return true;
    }
    return false;
  }
};

}  // namespace arcspan::detail
