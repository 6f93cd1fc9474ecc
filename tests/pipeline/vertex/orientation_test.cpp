// SPDX-License-Identifier: MIT
// Euler angles and quaternions against double precision.
#include <arcspan/vertex/orientation.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

double entry(const Rotation& rotation, std::size_t i, std::size_t j) {
  return std::ldexp(rotation.m[i][j].raw(), -30);
}

RotationEntry component(double v) {
  return RotationEntry::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(v, 30))));
}

}  // namespace

TEST_CASE("a quaternion of any length gives the rotation of its direction") {
  Random random(1801);
  double worst = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const double size = random.decades(1e-4, 0.999);
    double q[4];
    for (double& c : q) c = random.real(-1, 1);
    const Quaternion quaternion{component(size * q[0]), component(size * q[1]), component(size * q[2]),
                                component(size * q[3])};
    // From the rounded components, whose direction is the quaternion's.
    const double w = quaternion.w.raw(), x = quaternion.x.raw(), y = quaternion.y.raw(),
                 z = quaternion.z.raw();
    const double n = 2 / (w * w + x * x + y * y + z * z);
    const double exact[3][3] = {{1 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)},
                                {n * (x * y + w * z), 1 - n * (x * x + z * z), n * (y * z - w * x)},
                                {n * (x * z - w * y), n * (y * z + w * x), 1 - n * (x * x + y * y)}};
    const Rotation rotation = rotation_of(quaternion);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(entry(rotation, r, c) - exact[r][c]));
      }
    }
  }
  CHECK(worst < 0x1p-27);
}

TEST_CASE("Euler angles are applied in the order roll, pitch, yaw") {
  Random random(1802);
  double worst = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const auto turn = [&] { return Turn{static_cast<std::uint16_t>(random.bits())}; };
    const EulerAngles angles{turn(), turn(), turn()};
    const auto half = [](Turn t) { return std::numbers::pi * t.raw / 65536; };
    const double cy = std::cos(half(angles.yaw)), sy = std::sin(half(angles.yaw));
    const double cp = std::cos(half(angles.pitch)), sp = std::sin(half(angles.pitch));
    const double cr = std::cos(half(angles.roll)), sr = std::sin(half(angles.roll));
    // The product of the quaternions (cy + sy j)(cp + sp i)(cr + sr k).
    const Quaternion quaternion{
        component(0.99 * (cy * cp * cr + sy * sp * sr)), component(0.99 * (cy * sp * cr + sy * cp * sr)),
        component(0.99 * (sy * cp * cr - cy * sp * sr)), component(0.99 * (cy * cp * sr - sy * sp * cr))};
    const Rotation a = rotation_of(angles);
    const Rotation b = rotation_of(quaternion);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(entry(a, r, c) - entry(b, r, c)));
    }
  }
  CHECK(worst < 0x1p-26);
}

TEST_CASE("the zero quaternion turns nothing, and unit axes are exact") {
  const Rotation none = rotation_of(Quaternion{{}, {}, {}, {}});
  const Rotation one = rotation_of(Quaternion{RotationEntry::from_raw(5), {}, {}, {}});
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(none.m[r][c] == Rotation::identity().m[r][c]);
      CHECK(one.m[r][c] == Rotation::identity().m[r][c]);
    }
  }
}
