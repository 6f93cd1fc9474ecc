// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace arcspan::tools {

/// A vector of doubles: the tools compute with it before the conversion to fixed point.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double k) { return {a.x * k, a.y * k, a.z * k}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }

/// `a` at unit length; a zero (or not finite) vector stays what it is.
[[nodiscard]] inline Vec3 normalised(Vec3 a) {
  const double size = length(a);
  return size > 0 && std::isfinite(size) ? a * (1 / size) : a;
}

[[nodiscard]] inline bool finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace arcspan::tools
