// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/back_faces.hpp>
#include <arcspan/vertex/band_planes.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>

namespace arcspan::detail {

/// Finds the triangles of a mesh with planes that may be visible in the scissor.
class VisibleTriangles {
 public:
  /// Not known(): every triangle may be visible.
  constexpr explicit VisibleTriangles(const MeshView& mesh) : mesh_(mesh) {}
  /// `in_band` is true if triangles without a pixel centre in the scissor's rows are excluded.
  VisibleTriangles(const MeshView& mesh, const ClipTransform& transform, const Scissor& scissor, bool in_band)
      : mesh_(mesh), back_faces_(mesh, transform) {
    if (!back_faces_.known() || !in_band) return;
    band_.set(transform, scissor.rect().top, scissor.rect().bottom, mesh.plane_scale().radius);
  }

  /// True if next() and excludes_all() may be called. Then all vertices are inside the clip volume.
  [[nodiscard]] constexpr bool known() const { return back_faces_.known(); }
  /// True if back faces are known and the scissor is a band.
  [[nodiscard]] constexpr bool in_band() const { return band_.known(); }
  [[nodiscard]] constexpr const BackFaces& back_faces() const { return back_faces_; }
  [[nodiscard]] constexpr const BandPlanes& band() const { return band_; }
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

}  // namespace arcspan::detail
