// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstdint>

namespace arcspan {

/// A linear function of object space, x p.x + y p.y + z p.z + offset. Its magnitude is below 2^31 for every
/// 16-bit position.
struct ObjectForm {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  std::int32_t offset = 0;

  [[nodiscard]] ARCSPAN_INLINE constexpr bool is_positive_at(const ObjectPosition& p) const {
    return offset + x * p.x + y * p.y + z * p.z > 0;
  }
};

/// Finds the triangles that have no row in a band of the picture, before a vertex is transformed: the upper
/// and the lower border of the band are planes through the eye, and a triangle wholly beyond one of them has
/// no row in the band. Triangles near a border may be left to the raster, so that the picture is bit for bit
/// the same.
class BandPlanes {
 public:
  /// Not known(): every triangle may have rows in the band.
  constexpr BandPlanes() = default;
  /// Sets the planes of the band of the rows `first` ... `end` - 1 of the picture. Every vertex must be
  /// within `radius` of the object's origin and the sphere of this radius wholly inside the clip volume, as
  /// BackFaces::known() says.
  void set(const ClipTransform& transform, std::int32_t first, std::int32_t end, std::uint16_t radius);

  [[nodiscard]] constexpr bool known() const { return known_; }
  /// True if no triangle has rows in the band.
  [[nodiscard]] constexpr bool excludes_all() const { return excludes_all_; }

  /// The border that a vertex lies beyond: a bit for the one that is tested first, and one for the other.
  static constexpr std::uint8_t kFirstTested = 1;
  static constexpr std::uint8_t kSecondTested = 2;
  static constexpr std::uint8_t kBeyond = kFirstTested | kSecondTested;
  /// Returns `bits` with the border that `p` lies beyond, if any. A triangle has no row in the band if all
  /// vertices lie beyond the same border. Requires known().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint8_t beyond(const ObjectPosition& p,
                                                             std::uint8_t bits) const {
    if (first_tested_.is_positive_at(p)) return bits | kFirstTested;
    return second_tested_.is_positive_at(p) ? bits | kSecondTested : bits;
  }
  /// True if triangle i of `mesh` has no row in the band. Requires known().
  [[nodiscard]] ARCSPAN_INLINE constexpr bool excludes(const MeshView& mesh, std::size_t i) const {
    const TriangleIndices t = mesh.triangle(i);
    const ObjectPosition& a = mesh.position(t.a);
    if (first_tested_.is_positive_at(a)) {
      return first_tested_.is_positive_at(mesh.position(t.b)) &&
             first_tested_.is_positive_at(mesh.position(t.c));
    }
    return second_tested_.is_positive_at(a) && second_tested_.is_positive_at(mesh.position(t.b)) &&
           second_tested_.is_positive_at(mesh.position(t.c));
  }

 private:
  /// Positive beyond the border that is tested first: the one whose form is larger at the object's origin,
  /// because more of the object probably lies beyond it.
  ObjectForm first_tested_;
  ObjectForm second_tested_;  ///< positive beyond the other border
  bool known_ = false;
  bool excludes_all_ = false;
};

}  // namespace arcspan
