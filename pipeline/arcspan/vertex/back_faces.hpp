// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Tells from a mesh's planes which triangles are seen from the back, before any vertex is transformed
/// (decision 14). Errs to one side only: what it finds would be a back on the raster too, for the least
/// altitude of its picture is more than vertices move when they snap, so that a picture is bit for bit the
/// same with planes and without.
class BackFaces {
 public:
  /// Nothing can be told, and everything may be a front.
  constexpr BackFaces() = default;
  /// The same if the mesh has no planes, or the sphere about the object's origin that holds it is not wholly
  /// in front of the near plane and within the guard band, or the object is so small on the screen that every
  /// triangle may turn over by snapping.
  BackFaces(const MeshView& mesh, const ClipTransform& transform);

  /// Something can be told. All vertices are inside (ClipOutcode) then.
  [[nodiscard]] constexpr bool known() const { return planes_ != nullptr; }

  /// The first triangle from `i` on, below `count`, that may show its front; else `count`. Only if known().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::size_t next_front(std::size_t i, std::size_t count) const {
    const BackFaces held = *this;  // in registers
    while (i < count && held.is_back(i)) ++i;
    return i;
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_back(std::size_t i) const {
    // Below 127 * 2^22 + 2^24 in magnitude.
    const FacePlane& plane = planes_[i];
    return plane.x * eye_.x + plane.y * eye_.y + plane.z * eye_.z + plane.offset * offset_ < limit_;
  }

  const FacePlane* planes_ = nullptr;
  ObjectPoint eye_{};
  std::int32_t offset_ = 0;
  std::int32_t limit_ = 0;
};

}  // namespace arcspan
