// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

namespace arcspan::tools {

/// An affine map: `point` times the columns x, y, z, plus `translation`.
struct Affine {
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
  Vec3 translation{};

  [[nodiscard]] constexpr Vec3 direction(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  [[nodiscard]] constexpr Vec3 point(Vec3 p) const { return direction(p) + translation; }

  /// A normal to a surface: times the matrix of cofactors, which is the transposed inverse times the
  /// determinant; turned over if the map mirrors. Not of unit length.
  [[nodiscard]] constexpr Vec3 normal(Vec3 n) const {
    const Vec3 turned = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return mirrors() ? turned * -1 : turned;
  }
  [[nodiscard]] constexpr bool mirrors() const { return dot(x, cross(y, z)) < 0; }

  /// Applies `b` first.
  friend constexpr Affine operator*(const Affine& a, const Affine& b) {
    return {a.direction(b.x), a.direction(b.y), a.direction(b.z), a.point(b.translation)};
  }
};

}  // namespace arcspan::tools
