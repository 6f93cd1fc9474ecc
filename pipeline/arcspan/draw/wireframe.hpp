// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/draw/draw_options.hpp>
#include <arcspan/draw/line_stage.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

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
    if (are_inside(a, b, c)) {
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
  /// Draws the edges of a triangle across a clip plane. The sides along these planes are no edges.
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

}  // namespace detail

/// A shading method that draws the edges of triangles as lines of one colour instead of their areas:
///
///     draw_mesh<Wireframe<>>(mesh, transform, Wireframe<>::Lighting(Unlit::lighting(white)), frame, depth);
///
/// Front faces only, or all faces with DrawOptions::two_sided. `Colour` is Unlit, with operations or without.
/// An edge of two faces is drawn by both, with equal depth: with a depth buffer the second one changes
/// nothing, not even where lines are blended.
template <OneColour Colour = Unlit>
struct Wireframe : Colour {
  static constexpr bool kDrawsEdges = true;
  /// @cond for draw_mesh(), not in the reference
  template <class Target, class Mesh>
  using EdgesDrawer = detail::EdgeDrawer<Wireframe, Target, Mesh>;
  /// @endcond

  /// The lighting of `Colour` with the bias.
  struct Lighting : Colour::Lighting {
    // Not `Base`: nested operations take that of `Colour`.
    using Plain = typename Colour::Lighting;
    constexpr Lighting() = default;
    constexpr explicit Lighting(const Plain& colour, DepthBias nearer = {}) : Plain(colour), bias(nearer) {}
    /// Changes the bias, or another part of the material (PreparedMaterial::with).
    constexpr void set(DepthBias nearer) { bias = nearer; }
    template <class Part>
    requires requires(Plain& base, const Part& part) { {base.set(part)}; }
    constexpr void set(const Part& part) { Plain::set(part); }

    DepthBias bias;
  };
};

}  // namespace arcspan
