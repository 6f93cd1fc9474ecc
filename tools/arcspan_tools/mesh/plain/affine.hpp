// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <cmath>
#include <optional>

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
  /// The determinant of the linear part: the factor by which volumes grow, negative if the map mirrors.
  [[nodiscard]] constexpr double determinant() const { return dot(x, cross(y, z)); }
  [[nodiscard]] constexpr bool mirrors() const { return determinant() < 0; }

  /// Applies `b` first.
  friend constexpr Affine operator*(const Affine& a, const Affine& b) {
    return {a.direction(b.x), a.direction(b.y), a.direction(b.z), a.point(b.translation)};
  }
};

/// Adds `weight` times the map `a` to `sum`.
constexpr void add_weighted(Affine& sum, const Affine& a, double weight) {
  sum.x = sum.x + a.x * weight;
  sum.y = sum.y + a.y * weight;
  sum.z = sum.z + a.z * weight;
  sum.translation = sum.translation + a.translation * weight;
}

/// The map of a 4 × 4 matrix, column after column.
[[nodiscard]] constexpr Affine affine_of(const double* m) {
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

/// The map that takes back what `a` does; nothing if that is flat.
[[nodiscard]] inline std::optional<Affine> inverse(const Affine& a) {
  const double determinant = a.determinant();
  if (!(std::abs(determinant) > 1e-12 * length(a.x) * length(a.y) * length(a.z))) return std::nullopt;
  const Vec3 r0 = cross(a.y, a.z) * (1 / determinant);
  const Vec3 r1 = cross(a.z, a.x) * (1 / determinant);
  const Vec3 r2 = cross(a.x, a.y) * (1 / determinant);
  Affine back{{r0.x, r1.x, r2.x}, {r0.y, r1.y, r2.y}, {r0.z, r1.z, r2.z}, {}};
  back.translation = back.direction(a.translation) * -1;
  return back;
}

}  // namespace arcspan::tools
