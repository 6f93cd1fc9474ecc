// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/mesh/packed_normal.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A transformed vertex, the element of the vertex cache that draw_mesh() may be given. Shaded when the first
/// visible triangle needs it.
template <class Method>
struct CachedVertex {
  RasterVertex<Method> raster;
  std::uint8_t outcode;  ///< ClipOutcode; if not 0, `raster` is unset. BandVertices keeps its own bits here
  bool shaded;
};

namespace detail {

/// Outcode of a cached vertex that has not been transformed.
inline constexpr std::uint8_t kNotTransformed = 0xFF;

/// The side of a triangle that is seen.
enum class Facing : std::uint8_t { kFront, kBack };

/// Transforms and shades the vertices of one mesh.
template <class Method>
class VertexStage {
 public:
  constexpr VertexStage(const MeshView& mesh, const ClipTransform& transform,
                        const typename Method::Lighting& lighting)
      : mesh_(mesh), transform_(transform), lighting_(lighting) {}

  [[nodiscard]] constexpr const MeshView& mesh() const { return mesh_; }
  [[nodiscard]] constexpr const ClipTransform& transform() const { return transform_; }
  [[nodiscard]] constexpr const typename Method::Lighting& lighting() const { return lighting_; }

  [[nodiscard]] ARCSPAN_INLINE_AT_OS constexpr ClipPosition clip_position(std::size_t i) const {
    return transform_(mesh_.position(i));
  }

  /// Transforms vertex i of the mesh; it is not shaded yet.
  ARCSPAN_INLINE void transform(std::size_t i, CachedVertex<Method>& vertex) const {
    const ClipPosition position = clip_position(i);
    vertex.outcode = outcode(position, transform_.near_w());
    if (vertex.outcode == kInside) place_on_screen(position, transform_, vertex.raster);
    vertex.shaded = false;
  }

  /// Transforms vertex i unless that has been done.
  ARCSPAN_INLINE void transform_if_needed(std::size_t i, CachedVertex<Method>& vertex) const {
    if (vertex.outcode == kNotTransformed) transform_outlined(i, vertex);
  }

  /// Transforms vertex i of a mesh that is known to be in view.
  ARCSPAN_OUTLINE void transform_inside(std::size_t i, CachedVertex<Method>& vertex) const {
    place_on_screen(clip_position(i), transform_, vertex.raster);
    vertex.outcode = kInside;
    vertex.shaded = false;
  }

  /// Shades vertex i with its normal, unless that has been done.
  void shade(std::size_t i, CachedVertex<Method>& vertex) const {
    if (vertex.shaded) return;
    shade(i, Facing::kFront, vertex.raster.shade);
    vertex.shaded = true;
  }

  /// Shades vertex i with its normal for the front, with the opposite normal for the back.
  ARCSPAN_OUTLINE void shade(std::size_t i, Facing facing, typename Method::Vertex& shade) const {
    const Direction normal = unpack_normal(mesh_.normal(i));
    shade = Method::shade_vertex(lighting_, facing == Facing::kBack ? -normal : normal);
    if constexpr (TakesVertexData<Method>) Method::set_vertex_data(mesh_, i, shade);
  }

 private:
  ARCSPAN_OUTLINE void transform_outlined(std::size_t i, CachedVertex<Method>& vertex) const {
    transform(i, vertex);
  }

  const MeshView& mesh_;
  const ClipTransform& transform_;
  const typename Method::Lighting& lighting_;
};

}  // namespace detail
}  // namespace arcspan
