// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// A transformed vertex. It is shaded when the first visible triangle needs it.
template <class Method>
struct CachedVertex {
  /// Outcode of a vertex that has not been transformed.
  static constexpr std::uint8_t kNotTransformed = 0xFF;

  RasterVertex<Method> raster;
  std::uint8_t outcode;  ///< ClipOutcode bits; if not 0, `raster` is unset
  std::uint8_t shading;  ///< number of the shading that `raster.shade` has (VertexStage); 0 for none
};

namespace detail {

/// The side of a triangle that is seen.
enum class Facing : std::uint8_t { kFront, kBack };

/// True if a triangle of this doubled_area() is not drawn: it shows its back, and backs are not drawn, or it
/// has no area, and no edges are drawn.
template <class Method>
[[nodiscard]] ARCSPAN_INLINE constexpr bool is_culled_by_area(std::int32_t doubled, bool two_sided) {
  return doubled >= 0 && ((doubled == 0 && !DrawsEdges<Method>) || !two_sided);
}

/// True if all vertices of a triangle are inside the clip volume.
template <class Method>
[[nodiscard]] ARCSPAN_INLINE constexpr bool are_inside(const CachedVertex<Method>& a,
                                                       const CachedVertex<Method>& b,
                                                       const CachedVertex<Method>& c) {
  return (a.outcode | b.outcode | c.outcode) == 0;
}

/// True if a triangle lies outside one plane of the clip volume, or is_culled_by_area().
template <class Method>
[[nodiscard]] ARCSPAN_INLINE constexpr bool is_culled(const CachedVertex<Method>& a,
                                                      const CachedVertex<Method>& b,
                                                      const CachedVertex<Method>& c, bool two_sided) {
  if (!are_inside(a, b, c)) return (a.outcode & b.outcode & c.outcode) != 0;
  return is_culled_by_area<Method>(doubled_area(a.raster.position, b.raster.position, c.raster.position),
                                   two_sided);
}

}  // namespace detail

/// Transforms and shades the vertices of one mesh, for a vertex source (draw/vertex_source.hpp).
template <class Method, DrawableMesh Mesh = MeshView>
class VertexStage {
 public:
  /// `shading` numbers the lighting, above 0. Vertices that were shaded under another number are shaded
  /// again.
  constexpr VertexStage(const Mesh& mesh, const ClipTransform& transform,
                        const typename Method::Lighting& lighting, std::uint8_t shading = 1)
      : mesh_(mesh), transform_(transform), lighting_(lighting), shading_(shading) {}

  /// The triangles of the mesh, and what belongs to its vertices besides position and normal.
  [[nodiscard]] constexpr const MeshView& mesh() const { return mesh_.view(); }
  /// The mesh with the positions and normals that are drawn.
  [[nodiscard]] constexpr const Mesh& posed() const { return mesh_; }
  [[nodiscard]] constexpr const ClipTransform& transform() const { return transform_; }
  [[nodiscard]] constexpr const typename Method::Lighting& lighting() const { return lighting_; }

  /// The back faces of the mesh, as far as its planes tell. If they are known(), all vertices are inside the
  /// clip volume, and backs are not drawn.
  [[nodiscard]] constexpr const BackFaces& back_faces() const { return back_faces_; }

  /// Transforms vertex i of the mesh; it is not shaded yet.
  ARCSPAN_OUTLINE void transform(std::size_t i, CachedVertex<Method>& vertex) const {
    if (!std::is_same_v<Mesh, MeshView> || !back_faces_.known()) {  // only a MeshView has planes
      transform_inlined(i, vertex);
      return;
    }
    vertex.outcode = kInside;
    detail::place_on_screen(clip_position(i), transform_, vertex.raster);
    vertex.shading = 0;
  }
  /// Transforms all vertices of the mesh.
  void transform_all(CachedVertex<Method>* vertices) const {
    for (std::size_t i = 0; i < mesh().vertex_count(); ++i) transform_inlined(i, vertices[i]);
  }
  /// Shades vertex i, which is inside the clip volume, with its normal, unless that has been done.
  void shade(std::size_t i, CachedVertex<Method>& vertex) const {
    if (vertex.shading == shading_) return;
    shade(i, detail::Facing::kFront, vertex.raster.shade);
    vertex.shading = shading_;
  }

  /// The number of the lighting.
  [[nodiscard]] constexpr std::uint8_t shading() const { return shading_; }

  /// @cond for draw_mesh(), not in the reference
  void find_back_faces() {
    if constexpr (std::is_same_v<Mesh, MeshView>) {
      if (mesh_.planes() != nullptr) back_faces_ = BackFaces(mesh_, transform_);
    }
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr ClipPosition clip_position(std::size_t i) const {
    return transform_(mesh_.position(i));
  }
  /// Shades vertex i with its normal for the front, with the opposite normal for the back.
  ARCSPAN_OUTLINE void shade(std::size_t i, detail::Facing facing, typename Method::Vertex& shade) const {
    if constexpr (std::is_same_v<Mesh, MeshView>) {
      const Direction normal = unpack_normal(mesh_.normal(i));  // direction() makes gcc choose otherwise
      shade = Method::shade_vertex(lighting_, facing == detail::Facing::kBack ? -normal : normal);
    } else {
      const Direction normal = mesh_.direction(i);
      shade = Method::shade_vertex(lighting_, facing == detail::Facing::kBack ? -normal : normal);
    }
    if constexpr (TakesVertexData<Method>) Method::set_vertex_data(mesh(), i, shade);
  }
  /// @endcond

 private:
  ARCSPAN_INLINE void transform_inlined(std::size_t i, CachedVertex<Method>& vertex) const {
    const ClipPosition position = clip_position(i);
    vertex.outcode = outcode(position, transform_.w_range());
    if (vertex.outcode == kInside) detail::place_on_screen(position, transform_, vertex.raster);
    vertex.shading = 0;
  }

  const Mesh& mesh_;
  const ClipTransform& transform_;
  const typename Method::Lighting& lighting_;
  BackFaces back_faces_;
  std::uint8_t shading_;
};

namespace detail {

/// The vertices of a triangle in the order in which the side `facing` shows them counter-clockwise, from the
/// lowest index on. So the fan of the rest of a clipped triangle depends neither on which vertex is named
/// first nor on which side is the front.
[[nodiscard]] constexpr TriangleIndices in_clip_order(const TriangleIndices& t, Facing facing) {
  const TriangleIndices o = facing == Facing::kFront ? t : TriangleIndices{t.a, t.c, t.b};
  if (o.a <= o.b && o.a <= o.c) return o;
  return o.b <= o.c ? TriangleIndices{o.b, o.c, o.a} : TriangleIndices{o.c, o.a, o.b};
}

/// Clips a triangle, shaded as its side `facing`; sets `inside` to the vertices of the rest, of which there
/// are at most ClipPolygon::kCapacity, and returns their number. A function of its own, so that the stack of
/// the stages that follow does not hold the polygons.
template <class Method, class Mesh>
ARCSPAN_OUTLINE ARCSPAN_COLD std::size_t clip_triangle(const VertexStage<Method, Mesh>& stage,
                                                       const TriangleIndices& t, Facing facing,
                                                       RasterVertex<Method>* inside) {
  ClipPolygon<Method> polygon;
  std::size_t corner = 0;
  for (const std::uint16_t i : {t.a, t.b, t.c}) {
    ClipVertex<Method>& vertex = polygon[corner++];
    vertex.position = stage.clip_position(i);
    stage.shade(i, facing, vertex.shade);
  }
  clip_polygon(polygon, stage.transform().w_range());
  for (std::size_t i = 0; i < polygon.count(); ++i) {
    place_on_screen(polygon[i].position, stage.transform(), inside[i]);
    inside[i].shade = polygon[i].shade;
  }
  return polygon.count();
}

}  // namespace detail
}  // namespace arcspan
