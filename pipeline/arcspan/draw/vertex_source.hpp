// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>

#include <cstddef>
#include <cstdint>

/// Where the vertices of a triangle come from. A source has `next(i, count)`, the first triangle from i on
/// that may be visible (`count` if there is none), `operator[]`, the transformed vertex of an index, and
/// `kAllInside`, true if all vertices are known to be inside the clip volume.
namespace arcspan::detail {

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
  FrontVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache, const BackFaces& back_faces)
      : stage_(stage), back_faces_(back_faces), cache_(cache) {
    for (std::size_t i = 0; i < stage.mesh().vertex_count(); ++i) cache[i].outcode = kNotTransformed;
  }
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return back_faces_.next_front(i, count);
  }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const {
    CachedVertex<Method>& vertex = cache_[i];
    if (vertex.outcode == kNotTransformed) stage_.transform_inside(i, vertex);
    return vertex;
  }

 private:
  static constexpr std::uint8_t kNotTransformed = 0xFF;

  const VertexStage<Method>& stage_;
  const BackFaces& back_faces_;
  CachedVertex<Method>* cache_;
};

/// There is no cache: every triangle transforms its own three vertices.
template <class Method>
class UncachedVertices {
 public:
  static constexpr bool kAllInside = false;

  UncachedVertices(const VertexStage<Method>& stage, const BackFaces& back_faces)
      : stage_(stage), back_faces_(back_faces) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return back_faces_.known() ? back_faces_.next_front(i, count) : i;
  }
  [[nodiscard]] ARCSPAN_OUTLINE CachedVertex<Method> operator[](std::size_t i) const {
    CachedVertex<Method> vertex;
    stage_.transform(i, vertex);
    return vertex;
  }

 private:
  const VertexStage<Method>& stage_;
  const BackFaces& back_faces_;
};

}  // namespace arcspan::detail
