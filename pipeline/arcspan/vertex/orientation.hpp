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

/// A rotation by a quaternion w + xi + yj + zk. It need not be of unit length.
struct Quaternion {
  RotationEntry w;
  RotationEntry x;
  RotationEntry y;
  RotationEntry z;
};

[[nodiscard]] constexpr Rotation rotation_of(const EulerAngles& angles) {
  return Rotation::about_y(angles.yaw) * Rotation::about_x(angles.pitch) * Rotation::about_z(angles.roll);
}

/// Entries are within 2^-27 of the exact ones. The zero quaternion gives no rotation.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Rotation rotation_of(const Quaternion& q) {
  const std::array<std::int32_t, 4> u = unit_vector30<4>({q.w.raw(), q.x.raw(), q.y.raw(), q.z.raw()});
  if (is_zero(u)) return Rotation::identity();
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
