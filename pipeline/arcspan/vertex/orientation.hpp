// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unit_vector.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Angles of an orientation: `roll` about z first, then `pitch` about x, then `yaw` about y.
struct EulerAngles {
  Turn yaw;
  Turn pitch;
  Turn roll;
};

/// A rotation by a quaternion w + xi + yj + zk. It need not be of unit length. For a trackball of radius r
/// pixels, a drag by dx to the right and dy down turns by {2 r, dy, dx, 0}, as raw numbers, in view space.
struct Quaternion {
  RotationEntry w;
  RotationEntry x;
  RotationEntry y;
  RotationEntry z;
};

namespace detail {

/// w, x, y and z with 30 fraction bits, halved if one is above 1, so that sums of four products fit 63 bits.
/// The zero quaternion gives 1.
[[nodiscard]] constexpr std::array<std::int64_t, 4> quaternion_components(const Quaternion& q) {
  std::array<std::int64_t, 4> c = {q.w.raw(), q.x.raw(), q.y.raw(), q.z.raw()};
  bool has_large = false;
  bool has_any = false;
  for (const std::int64_t v : c) {
    has_large = has_large || v > kOne30 || v < -kOne30;
    has_any = has_any || v != 0;
  }
  if (!has_any) c[0] = kOne30;
  if (has_large) {
    for (std::int64_t& v : c) v /= 2;
  }
  return c;
}

}  // namespace detail

/// The rotation by `b`, then by `a`, as a quaternion of unit length: any number of products does not drift
/// from it. Its components are 2.30 in [-1, 1], within 3 * 2^-30 of the exact ones if those of `a` and `b`
/// are in [-1, 1]. Neither need be of unit length, and the zero quaternion gives no rotation.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  const auto [aw, ax, ay, az] = detail::quaternion_components(a);
  const auto [bw, bx, by, bz] = detail::quaternion_components(b);
  const std::array<std::int32_t, 4> u =
      unit_vector30<4>({aw * bw - ax * bx - ay * by - az * bz, aw * bx + ax * bw + ay * bz - az * by,
                        aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw});
  return {RotationEntry::from_raw(u[0]), RotationEntry::from_raw(u[1]), RotationEntry::from_raw(u[2]),
          RotationEntry::from_raw(u[3])};
}

[[nodiscard]] constexpr Rotation rotation_of(const EulerAngles& angles) {
  return Rotation::about_y(angles.yaw) * Rotation::about_x(angles.pitch) * Rotation::about_z(angles.roll);
}

/// Entries are within 2^-27 of the exact ones. The zero quaternion gives no rotation: all its products are 0.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Rotation rotation_of(const Quaternion& q) {
  const std::array<std::int32_t, 4> u = unit_vector30<4>({q.w.raw(), q.x.raw(), q.y.raw(), q.z.raw()});
  const auto twice = [&u](std::size_t i, std::size_t j) { return 2 * detail::product30(u[i], u[j]); };
  constexpr std::int64_t kUnit = detail::kOne30;
  const std::int64_t entries[3][3] = {
      {kUnit - twice(2, 2) - twice(3, 3), twice(1, 2) - twice(0, 3), twice(1, 3) + twice(0, 2)},
      {twice(1, 2) + twice(0, 3), kUnit - twice(1, 1) - twice(3, 3), twice(2, 3) - twice(0, 1)},
      {twice(1, 3) - twice(0, 2), twice(2, 3) + twice(0, 1), kUnit - twice(1, 1) - twice(2, 2)}};
  Rotation rotation{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) rotation.m[i][j] = detail::rotation_entry(entries[i][j]);
  }
  return rotation;
}

}  // namespace arcspan
