// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Finds the back faces of a mesh from its planes, before any vertex is transformed (decision 14).
///
/// It only finds triangles that are back faces on the raster too: the least altitude of their picture is
/// larger than the distance that snapping moves a vertex. Other back faces are left to the raster. So a
/// picture is bit for bit the same with planes and without.
class BackFaces {
 public:
  /// Not known(): every triangle may be a front face.
  constexpr BackFaces() = default;
  /// Not known() if the mesh has no planes, or its sphere (PlaneScale::radius around the object's origin) is
  /// not wholly in front of the near plane and within the guard band, or a vertex is beyond the far plane or
  /// close before it, or the object is so small on the screen that snapping may turn over every triangle.
  BackFaces(const MeshView& mesh, const ClipTransform& transform);

  /// True if back faces can be found. Then all vertices are inside the clip volume (ClipOutcode kInside).
  [[nodiscard]] constexpr bool known() const { return planes_ != nullptr; }

  /// The first of the triangles i ... count - 1 that may be a front face, or `count` if there is none.
  /// Requires known().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::size_t next_front(std::size_t i, std::size_t count) const {
    const BackFaces held = *this;  // a copy, so that its members stay in registers
    while (i < count && held.is_back(held.planes_[i])) ++i;
    return i;
  }
  /// True if the triangle with this plane is a back face. Requires known().
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_back(const FacePlane& plane) const {
    // The sum is below 127 * 2^22 + 2^24 in magnitude.
    return plane.x * eye_.x + plane.y * eye_.y + plane.z * eye_.z + plane.offset * offset_ < limit_;
  }

 private:
  const FacePlane* planes_ = nullptr;
  ObjectPoint eye_{};
  std::int32_t offset_ = 0;
  std::int32_t limit_ = 0;
};

}  // namespace arcspan
