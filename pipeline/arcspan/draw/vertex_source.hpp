// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/band_planes.hpp>

#include <cstddef>
#include <cstdint>

/// Where the vertices of a triangle come from. A source has `next(i, count)`, the first triangle from i on
/// that may be visible (`count` if there is none), `operator[]`, the transformed vertex of an index, and
/// `kAllInside`, true if all vertices are known to be inside the clip volume.
namespace arcspan::detail {

/// Finds the triangles of a mesh with planes that may be visible in the scissor.
class VisibleTriangles {
 public:
  /// Not known(): every triangle may be visible.
  constexpr explicit VisibleTriangles(const MeshView& mesh) : mesh_(mesh) {}
  VisibleTriangles(const MeshView& mesh, const ClipTransform& transform, const Scissor& scissor)
      : mesh_(mesh), back_faces_(mesh, transform) {
    if (!back_faces_.known() || !scissor.is_band()) return;
    band_ = BandPlanes(transform, scissor.rect().top, scissor.rect().bottom, mesh.plane_scale().radius);
  }

  /// True if next() and excludes_all() may be called. Then all vertices are inside the clip volume.
  [[nodiscard]] constexpr bool known() const { return back_faces_.known(); }
  /// True if no triangle is visible.
  [[nodiscard]] constexpr bool excludes_all() const { return band_.excludes_all(); }
  /// Returns the first of the triangles i ... count - 1 that may be visible, or `count` if there is none.
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    const std::size_t front = back_faces_.next_front(i, count);
    return band_.known() ? next_in_band(front, count) : front;
  }

 private:
  [[nodiscard]] ARCSPAN_OUTLINE std::size_t next_in_band(std::size_t i, std::size_t count) const {
    while (i < count && band_.excludes(mesh_, i)) i = back_faces_.next_front(i + 1, count);
    return i;
  }

  const MeshView& mesh_;
  BackFaces back_faces_;
  BandPlanes band_;
};

/// Every vertex of the mesh is transformed into the cache before the first triangle is drawn.
template <class Method>
class CachedVertices {
 public:
  static constexpr bool kAllInside = false;

  CachedVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache) : cache_(cache) {
    for (std::size_t i = 0; i < stage.mesh().vertex_count(); ++i) stage.transform(i, cache[i]);
  }
  [[nodiscard]] constexpr std::size_t next(std::size_t i, std::size_t) const { return i; }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const { return cache_[i]; }

 private:
  CachedVertex<Method>* cache_;
};

/// The back faces of the mesh are known, so only the vertices of other triangles are transformed, on first
/// use.
template <class Method>
class FrontVertices {
 public:
  static constexpr bool kAllInside = true;

  /// `back_faces` must be known().
  FrontVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache, const VisibleTriangles& visible)
      : stage_(stage), visible_(visible), cache_(cache) {
    for (std::size_t i = 0; i < stage.mesh().vertex_count(); ++i) cache[i].outcode = kNotTransformed;
  }
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return visible_.next(i, count);
  }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const {
    CachedVertex<Method>& vertex = cache_[i];
    if (vertex.outcode == kNotTransformed) stage_.transform_inside(i, vertex);
    return vertex;
  }

 private:
  const VertexStage<Method>& stage_;
  const VisibleTriangles& visible_;
  CachedVertex<Method>* cache_;
};

/// The vertices that a BandCache keeps from band to band, transformed on first use.
template <class Method>
class KeptVertices {
 public:
  static constexpr bool kAllInside = false;

  /// `rows` are the rows of the triangles, or null; the band has the rows `first` ... `end` - 1.
  KeptVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache, const TriangleRows* rows,
               const VisibleTriangles& visible, std::int32_t first, std::int32_t end)
      : stage_(stage),
        visible_(visible),
        cache_(cache),
        rows_(rows),
        first_(first >> TriangleRows::kGroupBits),
        last_((end - 1) >> TriangleRows::kGroupBits) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    if (rows_ == nullptr) return visible_.known() ? visible_.next(i, count) : i;
    while (i < count && (rows_[i].last < first_ || rows_[i].first > last_)) ++i;
    return i;
  }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const {
    transform_if_needed(stage_, i, cache_[i]);
    return cache_[i];
  }

 private:
  const VertexStage<Method>& stage_;
  const VisibleTriangles& visible_;
  CachedVertex<Method>* cache_;
  const TriangleRows* rows_;
  std::int32_t first_;  ///< groups of rows of the band
  std::int32_t last_;
};

/// There is no cache: every triangle transforms its own three vertices.
template <class Method>
class UncachedVertices {
 public:
  static constexpr bool kAllInside = false;

  UncachedVertices(const VertexStage<Method>& stage, const VisibleTriangles& visible)
      : stage_(stage), visible_(visible) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return visible_.known() ? visible_.next(i, count) : i;
  }
  [[nodiscard]] ARCSPAN_OUTLINE CachedVertex<Method> operator[](std::size_t i) const {
    CachedVertex<Method> vertex;
    stage_.transform(i, vertex);
    return vertex;
  }

 private:
  const VertexStage<Method>& stage_;
  const VisibleTriangles& visible_;
};

}  // namespace arcspan::detail
