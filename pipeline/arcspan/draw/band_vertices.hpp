// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/draw/visible_triangles.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/leading_zeros.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/band_planes.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// A source of vertices (vertex_source.hpp) for a band, where the back faces are known: the outcode of a
/// vertex says beyond which border of the band it lies, so that triangles of other bands are found by their
/// outcodes. Vertices of the others are transformed on first use.
template <class Method>
class BandVertices {
 public:
  static constexpr bool kAllInside = true;

  /// True if it is faster than to test each triangle by itself: vertices belong to several triangles.
  [[nodiscard]] static constexpr bool suits(const MeshView& mesh) {
    return mesh.vertex_count() <= mesh.triangle_count();
  }

  /// `visible` must be in_band().
  BandVertices(const VertexStage<Method>& stage, CachedVertex<Method>* cache, const VisibleTriangles& visible)
      : stage_(stage), cache_(cache), back_faces_(visible.back_faces()) {
    place(stage.mesh(), visible.band(), cache);
  }

  /// Continues where the last call ended, so that `i` is not needed.
  [[nodiscard]] ARCSPAN_INLINE std::size_t next(std::size_t, std::size_t count) {
    while (found_ == 0) {
      if (end_ == count) return count;
      const std::size_t begin = end_;
      end_ = count - begin < kBatch ? count : begin + kBatch;
      found_ = find(begin, end_);
    }
    const int zeros = leading_zeros(found_);
    found_ &= ~(kFirst >> zeros);
    return end_ - kBatch + static_cast<std::size_t>(zeros);
  }
  [[nodiscard]] CachedVertex<Method>& operator[](std::size_t i) const {
    CachedVertex<Method>& vertex = cache_[i];
    if ((vertex.outcode & kPending) != 0) transform(i, vertex);
    return vertex;
  }

 private:
  /// Added to the outcode of a vertex that is not transformed.
  static constexpr std::uint8_t kPending = 128;

  /// Triangles are found in batches, because a search takes all registers. The last one of a batch is bit 0.
  static constexpr std::size_t kBatch = 32;
  static constexpr std::uint32_t kFirst = std::uint32_t{1} << (kBatch - 1);

  ARCSPAN_OUTLINE void transform(std::size_t i, CachedVertex<Method>& vertex) const {
    place_on_screen(stage_.clip_position(i), stage_.transform(), vertex.raster);
    vertex.outcode ^= kPending;
    vertex.shaded = false;
  }
  /// Sets the outcodes of all vertices.
  ARCSPAN_OUTLINE static void place(const MeshView& mesh, const BandPlanes& planes,
                                    CachedVertex<Method>* cache) {
    const BandPlanes held = planes;
    const std::size_t count = mesh.vertex_count();
    for (std::size_t i = 0; i < count; ++i) {
      cache[i].outcode = held.beyond(mesh.position(i), kPending);
    }
  }

  /// Returns which triangles of a batch, from `begin` to `end` - 1, may have rows in the band.
  [[nodiscard]] ARCSPAN_OUTLINE std::uint32_t find(std::size_t begin, std::size_t end) const {
    const MeshView& mesh = stage_.mesh();
    return mesh.indices8() != nullptr ? find_by(mesh.indices8(), begin, end)
                                      : find_by(mesh.indices16(), begin, end);
  }
  template <class Index>
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t find_by(const Index* indices, std::size_t begin,
                                                     std::size_t end) const {
    const BackFaces held = back_faces_;  // a copy, so that its members stay in registers
    // Addressed by bytes. The stride is hidden, so that the compiler keeps the multiply: one instruction
    // where an index takes two.
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(cache_);
    const std::uint8_t* const outcodes = bytes + (&cache_->outcode - bytes);
    std::size_t stride = sizeof(CachedVertex<Method>);
    hide_value(stride);
    const FacePlane* plane = stage_.mesh().planes() + begin;
    const Index* t = indices + 3 * begin;
    std::uint32_t found = 0;
    for (std::uint32_t bit = kFirst >> (kBatch - (end - begin)); bit != 0; bit >>= 1, ++plane, t += 3) {
      if (held.is_back(*plane)) continue;
      const std::uint32_t beyond =
          outcodes[t[0] * stride] & outcodes[t[1] * stride] & outcodes[t[2] * stride];
      if ((beyond & BandPlanes::kBeyond) == 0) found |= bit;
    }
    return found;
  }

  const VertexStage<Method>& stage_;
  CachedVertex<Method>* cache_;
  const BackFaces& back_faces_;
  std::uint32_t found_ = 0;  ///< triangles of the batch that are left
  std::size_t end_ = 0;      ///< of the batch
};

}  // namespace arcspan::detail
