// SPDX-License-Identifier: MIT
#include <arcspan/vertex/rotation.hpp>

#include <initializer_list>

namespace arcspan {

namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 30;

/// x * y with 30 fraction bits, rounded.
constexpr std::int64_t product(std::int64_t x, std::int64_t y) { return (x * y + (kOne >> 1)) >> 30; }

/// `angle` in 0...8192 (an eighth of a turn) as radians: times 2 pi / 2^16.
constexpr std::int64_t radians(std::int64_t angle) {
  constexpr std::int64_t kTwoPi = 6746518852;  // 30 fraction bits
  return (angle * kTwoPi + (std::int32_t{1} << 15)) >> 16;
}

/// 0 <= dividend < 2^32: a short division, which targets have or have code for anyway.
std::int64_t quotient(std::int64_t dividend, std::uint8_t divisor) {
  return static_cast<std::uint32_t>(dividend) / divisor;
}

/// Taylor's series to x^11 and x^10; the next terms are below 2^-35 at an eighth of a turn.
std::int64_t octant_sine(std::int64_t angle) {
  const std::int64_t x = radians(angle);
  const std::int64_t x2 = product(x, x);
  std::int64_t sum = kOne;
  for (const std::uint8_t divisor : std::initializer_list<std::uint8_t>{10 * 11, 8 * 9, 6 * 7, 4 * 5, 2 * 3})
    sum = kOne - quotient(product(x2, sum), divisor);
  return product(x, sum);
}

std::int64_t octant_cosine(std::int64_t angle) {
  const std::int64_t x = radians(angle);
  const std::int64_t x2 = product(x, x);
  std::int64_t sum = kOne;
  for (const std::uint8_t divisor : std::initializer_list<std::uint8_t>{9 * 10, 7 * 8, 5 * 6, 3 * 4, 1 * 2})
    sum = kOne - quotient(product(x2, sum), divisor);
  return sum;
}

RotationEntry entry(std::int64_t value) {
  const std::int64_t limit = kOne - 1;
  return RotationEntry::from_raw(static_cast<std::int32_t>(value > limit    ? limit
                                                           : value < -limit ? -limit
                                                                            : value));
}

/// Rotation in the plane of axes i and j, from i towards j.
Rotation in_plane(int i, int j, Turn angle) {
  Rotation rotation = Rotation::identity();
  rotation.m[i][i] = cosine(angle);
  rotation.m[j][j] = cosine(angle);
  rotation.m[i][j] = -sine(angle);
  rotation.m[j][i] = sine(angle);
  return rotation;
}

}  // namespace

RotationEntry sine(Turn angle) {
  constexpr std::int64_t kEighth = 8192;
  const std::int64_t in_quarter = angle.raw & 0x3FFF;
  const bool mirrored = (angle.raw & 0x4000) != 0;
  const std::int64_t folded = mirrored ? 2 * kEighth - in_quarter : in_quarter;
  const std::int64_t value = folded <= kEighth ? octant_sine(folded) : octant_cosine(2 * kEighth - folded);
  return entry((angle.raw & 0x8000) != 0 ? -value : value);
}

RotationEntry cosine(Turn angle) { return sine(angle + Turn{0x4000}); }

Rotation Rotation::identity() {
  Rotation rotation{};
  for (int i = 0; i < 3; ++i) rotation.m[i][i] = entry(kOne);
  return rotation;
}

Rotation Rotation::about_x(Turn angle) { return in_plane(1, 2, angle); }
Rotation Rotation::about_y(Turn angle) { return in_plane(2, 0, angle); }
Rotation Rotation::about_z(Turn angle) { return in_plane(0, 1, angle); }

Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation rotation;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      std::int64_t sum = 0;
      for (int k = 0; k < 3; ++k) sum += product(a.m[i][k].raw(), b.m[k][j].raw());
      rotation.m[i][j] = entry(sum);
    }
  }
  return rotation;
}

Direction Rotation::to_object(const Direction& view) const {
  std::int64_t rotated[3];
  for (int j = 0; j < 3; ++j) {
    rotated[j] = std::int64_t{m[0][j].raw()} * view.x.raw() + std::int64_t{m[1][j].raw()} * view.y.raw() +
                 std::int64_t{m[2][j].raw()} * view.z.raw();
  }
  return normalised_wide(rotated[0], rotated[1], rotated[2]);
}

}  // namespace arcspan
