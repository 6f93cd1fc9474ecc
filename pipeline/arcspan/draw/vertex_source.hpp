// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/draw/visible_triangles.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// Where the vertices of a triangle come from. A source has `next(i, count)`, the first triangle from i on
/// that may be visible (`count` if there is none), `operator[]`, the transformed vertex of an index, and
/// `kAllInside`, true if all vertices are known to be inside the clip volume. `i` is 0 in the first call of
/// next() and one more than the last result in each further one, and `count` stays the same: a source may
/// keep state between calls and ignore `i`.
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
  [[nodiscard]] ARCSPAN_INLINE_AT_OS CachedVertex<Method>& operator[](std::size_t i) const {
    return cache_[i];
  }

 private:
  CachedVertex<Method>* cache_;
};

/// The back faces of the mesh are known, so only the vertices of other triangles are transformed, on first
/// use.
template <class Method>
class FrontVertices {
 public:
  static constexpr bool kAllInside = true;

  /// The back faces must be known. Vertices of `cache` are forgotten, or have been transformed like this.
  FrontVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache,
                const VisibleTriangles& visible)
      : stage_(stage), visible_(visible), cache_(cache) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    return visible_.next(i, count);
  }
  [[nodiscard]] ARCSPAN_INLINE_AT_OS CachedVertex<Method>& operator[](std::size_t i) const {
    CachedVertex<Method>& vertex = cache_[i];
    if (vertex.outcode == kNotTransformed) stage_.transform_inside(i, vertex);
    return vertex;
  }

 private:
  const VertexStage<Method>& stage_;
  const VisibleTriangles& visible_;
  CachedVertex<Method>* cache_;
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
