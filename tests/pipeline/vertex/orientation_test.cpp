// SPDX-License-Identifier: MIT
// Euler angles and quaternions against double precision.
#include <arcspan/vertex/orientation.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

using namespace arcspan;
using namespace arcspan::test;

namespace {

double entry(const Rotation& rotation, std::size_t i, std::size_t j) {
  return std::ldexp(rotation.m[i][j].raw(), -30);
}

/// w, x, y, z.
using Components = std::array<double, 4>;

Components components(const Quaternion& q) {
  const auto real = [](RotationEntry c) { return std::ldexp(c.raw(), -30); };
  return {real(q.w), real(q.x), real(q.y), real(q.z)};
}

double length(const Components& q) { return std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])); }

/// Hamilton's product, of unit length.
Components product(const Components& a, const Components& b) {
  Components p = {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                  a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                  a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
                  a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  const double size = length(p);
  for (double& c : p) c /= size;
  return p;
}

double difference(const Components& a, const Components& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
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

TEST_CASE("a product of quaternions of any length is exact to three steps") {
  Random random(1803);
  double worst = 0;
  double worst_length = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const auto quaternion = [&] {
      const double size = random.decades(1e-8, 1);
      Quaternion q{};
      for (RotationEntry* c : {&q.w, &q.x, &q.y, &q.z}) *c = component(size * random.real(-1, 1));
      return q;
    };
    const Quaternion a = quaternion();
    const Quaternion b = quaternion();
    if (length(components(a)) == 0 || length(components(b)) == 0) continue;
    const Components found = components(a * b);
    worst = std::max(worst, difference(found, product(components(a), components(b))));
    worst_length = std::max(worst_length, std::abs(length(found) - 1));
  }
  CHECK(worst <= 3 * 0x1p-30);
  CHECK(worst_length <= 3 * 0x1p-30);
}

TEST_CASE("a product of quaternions turns as the product of their rotations") {
  Random random(1804);
  double worst = 0;
  for (int i = 0; i < share_of(5000); ++i) {
    const auto any = [&] { return RotationEntry::from_raw(static_cast<std::int32_t>(random.bits())); };
    const Quaternion a{any(), any(), any(), any()};  // components in [-2, 2), too
    const Quaternion b{any(), any(), any(), any()};
    const Rotation joined = rotation_of(a * b);
    const Rotation wanted = rotation_of(a) * rotation_of(b);
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(entry(joined, r, c) - entry(wanted, r, c)));
    }
  }
  CHECK(worst < 0x1p-26);
}

TEST_CASE("many small turns keep a quaternion's length and add up") {
  // A turn by 2 atan(1 / 512) about a slanted axis, as a trackball makes it of a drag.
  const Quaternion turn{component(1.0), component(0.6 / 512), component(0), component(0.8 / 512)};
  Quaternion sum{component(1.0), {}, {}, {}};
  constexpr int kTurns = 20000;
  double worst_length = 0;
  for (int i = 0; i < kTurns; ++i) {
    sum = turn * sum;
    worst_length = std::max(worst_length, std::abs(length(components(sum)) - 1));
  }
  CHECK(worst_length <= 3 * 0x1p-30);
  const Components axis = components(turn);
  const double sine = std::hypot(axis[1], axis[3]);
  const double angle = kTurns * std::atan2(sine, axis[0]);
  const Components wanted = {std::cos(angle), std::sin(angle) * axis[1] / sine, 0,
                             std::sin(angle) * axis[3] / sine};
  CHECK(difference(components(sum), wanted) < kTurns * 0x1p-30);
}

TEST_CASE("a drag turns the front of a trackball with it") {
  const auto raw = [](std::int32_t v) { return RotationEntry::from_raw(v); };
  const auto dragged = [&](std::int32_t dx, std::int32_t dy) {
    return rotation_of(Quaternion{raw(200), raw(dy), raw(dx), raw(0)} * Quaternion{raw(1), {}, {}, {}});
  };
  // The third column is where the point in front of the ball goes; y is up.
  const double turn = 2 * std::atan(10.0 / 200);
  CHECK(std::abs(entry(dragged(10, 0), 0, 2) - std::sin(turn)) < 0x1p-27);
  CHECK(std::abs(entry(dragged(0, 10), 1, 2) + std::sin(turn)) < 0x1p-27);
}

TEST_CASE("extreme quaternions have products of unit length") {
  const auto raw = [](std::int32_t v) { return RotationEntry::from_raw(v); };
  const Quaternion zero{};
  const Quaternion least{raw(INT32_MIN), raw(INT32_MIN), raw(INT32_MIN), raw(INT32_MIN)};
  const Quaternion mixed{raw(INT32_MIN), raw(INT32_MAX), raw(INT32_MIN), raw(INT32_MAX)};
  const Quaternion small{raw(0), raw(0), raw(-1), raw(0)};
  for (const Quaternion& a : {zero, least, mixed, small}) {
    for (const Quaternion& b : {zero, least, mixed, small})
      CHECK(std::abs(length(components(a * b)) - 1) <= 3 * 0x1p-30);
  }
  CHECK(components(zero * zero) == Components{1, 0, 0, 0});
  CHECK(components(small * zero) == Components{0, 0, -1, 0});
  CHECK(components(small * small) == Components{-1, 0, 0, 0});
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
