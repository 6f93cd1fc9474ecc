// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/affine.hpp>

#include <cmath>
#include <optional>

namespace arcspan::tools {

/// A rotation by a quaternion x·i + y·j + z·k + w. Any length but 0 stands for the same rotation.
struct Quaternion {
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;

  friend constexpr Quaternion operator+(Quaternion a, Quaternion b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
  }
  friend constexpr Quaternion operator*(Quaternion q, double k) {
    return {q.x * k, q.y * k, q.z * k, q.w * k};
  }
  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

[[nodiscard]] constexpr double inner(Quaternion a, Quaternion b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

/// `q` at unit length; the identity if it has none.
[[nodiscard]] inline Quaternion unit_length(Quaternion q) {
  const double size = std::sqrt(inner(q, q));
  return size > 0 && std::isfinite(size) ? q * (1 / size) : Quaternion{};
}

/// Spherical interpolation between unit quaternions along the shorter arc, from `a` at 0 to `b` at 1.
[[nodiscard]] inline Quaternion slerp(Quaternion a, Quaternion b, double t) {
  double cosine = inner(a, b);
  if (cosine < 0) b = b * -1;
  cosine = std::abs(cosine);
  if (cosine > 1 - 1e-12) return unit_length(a * (1 - t) + b * t);
  const double angle = std::acos(cosine);
  return unit_length(a * std::sin((1 - t) * angle) + b * std::sin(t * angle));
}

/// The place of a node within its parent: scaled, then rotated, then moved.
struct NodeTransform {
  Vec3 translation{};
  Quaternion rotation{};
  Vec3 scale{1, 1, 1};

  [[nodiscard]] Affine affine() const {
    const Vec3 axis{rotation.x, rotation.y, rotation.z};
    const double squared = inner(rotation, rotation);
    const auto rotated = [&](Vec3 v) {
      const Vec3 half = cross(axis, v) + v * rotation.w;
      return v + cross(axis, half) * (2 / squared);
    };
    return {rotated({1, 0, 0}) * scale.x, rotated({0, 1, 0}) * scale.y, rotated({0, 0, 1}) * scale.z,
            translation};
  }
  friend bool operator==(const NodeTransform&, const NodeTransform&) = default;
};

/// The transform that is the same as `affine`; nothing if that is sheared or flat.
[[nodiscard]] std::optional<NodeTransform> split(const Affine& affine);

}  // namespace arcspan::tools
