// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>

#include <tests/support/random.hpp>

#include <cmath>
#include <numbers>

namespace arcspan::test {

/// A vector in double precision: what the tests compute truths with.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(double s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
};

[[nodiscard]] inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vec3 v) { return std::sqrt(dot(v, v)); }
[[nodiscard]] inline Vec3 normalised(Vec3 v) { return (1 / length(v)) * v; }

/// Precise for small angles and near 180 degrees alike.
[[nodiscard]] inline double angle_between(Vec3 a, Vec3 b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

[[nodiscard]] inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }
[[nodiscard]] inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// Uniform on the sphere.
[[nodiscard]] inline Vec3 random_unit(Random& random) {
  const double z = random.real(-1, 1);
  const double phi = random.real(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A unit vector at `angle` from v, in a random direction.
[[nodiscard]] inline Vec3 tilted(Random& random, Vec3 v, double angle) {
  Vec3 side = cross(v, random_unit(random));
  while (length(side) < 0.1) side = cross(v, random_unit(random));
  return std::cos(angle) * v + std::sin(angle) * normalised(side);
}

/// Rounded to the nearest Direction.
[[nodiscard]] inline Direction to_direction(Vec3 v) {
  const auto component = [](double c) {
    return DirectionComponent::from_raw(static_cast<std::int32_t>(std::lround(c * 32768)));
  };
  return {component(v.x), component(v.y), component(v.z)};
}
[[nodiscard]] inline Vec3 to_vec3(const Direction& v) {
  return (1.0 / 32768) * Vec3{double(v.x.raw()), double(v.y.raw()), double(v.z.raw())};
}
[[nodiscard]] inline double to_double(Cosine v) { return std::ldexp(v.raw(), -Cosine::kFraction); }

}  // namespace arcspan::test
