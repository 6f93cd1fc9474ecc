// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace arcspan::tools {

/// A degree in radians.
inline constexpr double kDegree = std::numbers::pi / 180;

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

[[nodiscard]] inline bool finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// `a` at unit length; a zero (or not finite) vector stays what it is. It is scaled by a power of two first,
/// since the length of very large or very small vectors is not a double.
[[nodiscard]] inline Vec3 normalised(Vec3 a) {
  const double largest = std::fmax(std::fmax(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
  if (!(largest > 0) || !finite(a)) return a;
  const int exponent = -std::ilogb(largest);
  const Vec3 scaled = {std::ldexp(a.x, exponent), std::ldexp(a.y, exponent), std::ldexp(a.z, exponent)};
  return scaled * (1 / length(scaled));
}

}  // namespace arcspan::tools
