// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/draw/visible_triangles.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// Marks vertices as not transformed yet.
template <class Method>
void forget_vertices(CachedVertex<Method>* cache, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) cache[i].outcode = kNotTransformed;
}

/// The vertices that a BandCache keeps from band to band, transformed on first use: a source of vertices
/// (vertex_source.hpp).
template <class Method>
class KeptVertices {
 public:
  static constexpr bool kAllInside = false;

  /// `rows` are the rows of the triangles, or null; `band` is the scissor's rectangle.
  KeptVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache, const TriangleRows* rows,
               const VisibleTriangles& visible, const Rect& band)
      : stage_(stage),
        visible_(visible),
        cache_(cache),
        rows_(rows),
        first_(band.top >> TriangleRows::kGroupBits),
        last_((band.bottom - 1) >> TriangleRows::kGroupBits) {}
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t i, std::size_t count) const {
    if (rows_ == nullptr) return visible_.known() ? visible_.next(i, count) : i;
    while (i < count && (rows_[i].last < first_ || rows_[i].first > last_)) ++i;
    return i;
  }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const {
    stage_.transform_if_needed(i, cache_[i]);
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

}  // namespace arcspan::detail
