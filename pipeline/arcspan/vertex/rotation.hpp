// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// An angle in 65536ths of a full turn. Sums wrap at a full turn.
struct Turn {
  std::uint16_t raw = 0;

  friend constexpr Turn operator+(Turn a, Turn b) { return {static_cast<std::uint16_t>(a.raw + b.raw)}; }
  friend constexpr Turn operator-(Turn a) { return {static_cast<std::uint16_t>(-a.raw)}; }
};

namespace detail {

inline constexpr std::int64_t kOne30 = std::int64_t{1} << 30;

/// x * y of numbers with 30 fraction bits, rounded.
[[nodiscard]] constexpr std::int64_t product30(std::int64_t x, std::int64_t y) {
  return (x * y + (kOne30 >> 1)) >> 30;
}

/// A Taylor series 1 - x^2/d4 (1 - x^2/d3 (...)) with divisors d0 ... d4, 30 fraction bits: cos(x), or sin(x)
/// / x. `x` is an angle of at most an eighth of a turn in radians. The series ends with x^10 (sine: x^11);
/// the next terms are below 2^-35.
[[nodiscard]] constexpr std::int64_t taylor30(std::int64_t x, const std::array<std::uint8_t, 5>& divisors) {
  const std::int64_t x2 = product30(x, x);
  std::int64_t sum = kOne30;
  for (std::size_t i = 0; i < divisors.size(); ++i) {
    // The product is below 2^32, so that the division is a 32-bit one.
    sum = kOne30 - static_cast<std::uint32_t>(product30(x2, sum)) / divisors[i];
  }
  return sum;
}

/// `angle` (0...8192 of a Turn) in radians, 30 fraction bits.
[[nodiscard]] constexpr std::int64_t radians30(std::int64_t angle) {
  constexpr std::int64_t kTwoPi = 6746518852;  // 30 fraction bits
  return (angle * kTwoPi + (std::int32_t{1} << 15)) >> 16;
}

/// Sine and cosine of an angle in 0...8192 (an eighth of a turn), 30 fraction bits.
[[nodiscard]] constexpr std::int64_t octant_sine(std::int64_t angle) {
  const std::int64_t x = radians30(angle);
  return product30(x, taylor30(x, {10 * 11, 8 * 9, 6 * 7, 4 * 5, 2 * 3}));
}

[[nodiscard]] constexpr std::int64_t octant_cosine(std::int64_t angle) {
  return taylor30(radians30(angle), {9 * 10, 7 * 8, 5 * 6, 3 * 4, 1 * 2});
}

/// `value` with 30 fraction bits, saturated to 1 - 2^-30 in magnitude.
[[nodiscard]] constexpr RotationEntry rotation_entry(std::int64_t value) {
  return RotationEntry::from_raw(limited(value, static_cast<std::int32_t>(kOne30 - 1)));
}

}  // namespace detail

/// The sine of an angle, at most 1 - 2^-30 in magnitude, absolute error at most 2^-28 (swept in the tests).
/// It takes 64-bit products: fit for the set-up of objects, too slow for vertices.
[[nodiscard]] ARCSPAN_OUTLINE constexpr RotationEntry sine(Turn angle) {
  constexpr std::int64_t kEighth = 8192;
  const std::int64_t in_quarter = angle.raw & 0x3FFF;
  const bool mirrored = (angle.raw & 0x4000) != 0;
  const std::int64_t folded = mirrored ? 2 * kEighth - in_quarter : in_quarter;
  const std::int64_t value =
      folded <= kEighth ? detail::octant_sine(folded) : detail::octant_cosine(2 * kEighth - folded);
  return detail::rotation_entry((angle.raw & 0x8000) != 0 ? -value : value);
}
/// The cosine of an angle, in all else like sine().
[[nodiscard]] constexpr RotationEntry cosine(Turn angle) { return sine(angle + Turn{0x4000}); }

/// A rotation from object space to view space. Its rows are the axes of view space in object space.
struct Rotation {
  RotationEntry m[3][3];

  /// No rotation. Entries of 1 are 1 - 2^-30, which leaves room for sums.
  [[nodiscard]] static constexpr Rotation identity();
  /// Right-handed rotations about the axes of the space that they are applied in.
  [[nodiscard]] static constexpr Rotation about_x(Turn angle);
  [[nodiscard]] static constexpr Rotation about_y(Turn angle);
  [[nodiscard]] static constexpr Rotation about_z(Turn angle);

  /// A direction of view space (towards a light or the eye) in object space, normalised. Applies the
  /// transpose.
  [[nodiscard]] constexpr Direction to_object(const Direction& view) const;
};

namespace detail {

/// The rotation in the plane of axes i and j, from i towards j.
[[nodiscard]] constexpr Rotation rotation_in_plane(std::size_t i, std::size_t j, Turn angle) {
  Rotation rotation = Rotation::identity();
  rotation.m[i][i] = cosine(angle);
  rotation.m[j][j] = cosine(angle);
  rotation.m[i][j] = -sine(angle);
  rotation.m[j][i] = sine(angle);
  return rotation;
}

}  // namespace detail

constexpr Rotation Rotation::identity() {
  Rotation rotation{};
  for (std::size_t i = 0; i < 3; ++i) rotation.m[i][i] = detail::rotation_entry(detail::kOne30);
  return rotation;
}

constexpr Rotation Rotation::about_x(Turn angle) { return detail::rotation_in_plane(1, 2, angle); }
constexpr Rotation Rotation::about_y(Turn angle) { return detail::rotation_in_plane(2, 0, angle); }
constexpr Rotation Rotation::about_z(Turn angle) { return detail::rotation_in_plane(0, 1, angle); }

namespace detail {

/// True if each dot product of two rows is within 2^-18 of 1 or 0, as the margin of BackFaces needs.
[[nodiscard]] constexpr bool is_orthonormal(const Rotation& rotation) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      std::int64_t sum = i == j ? -kOne30 : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += product30(rotation.m[i][k].raw(), rotation.m[j][k].raw());
      if (sum > kOne30 >> 18 || sum < -(kOne30 >> 18)) return false;
    }
  }
  return true;
}

}  // namespace detail

/// The rotation by `b`, then by `a`. Each product shortens the rows by about 2^-30, so that a chain of tens
/// of thousands is no rotation any more for Placement: keep angles, or a Quaternion, which does not drift.
[[nodiscard]] ARCSPAN_OUTLINE constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
  Rotation rotation{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      std::int64_t sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += detail::product30(a.m[i][k].raw(), b.m[k][j].raw());
      rotation.m[i][j] = detail::rotation_entry(sum);
    }
  }
  return rotation;
}

constexpr Direction Rotation::to_object(const Direction& view) const {
  std::int64_t rotated[3] = {};
  for (std::size_t j = 0; j < 3; ++j) {
    const auto product = [&](std::size_t i, DirectionComponent c) {
      return static_cast<std::uint64_t>(std::int64_t{m[i][j].raw()} * c.raw());
    };
    // The sum wraps if these are neither a rotation nor a unit vector.
    rotated[j] = static_cast<std::int64_t>(product(0, view.x) + product(1, view.y) + product(2, view.z));
  }
  return normalised_wide(rotated[0], rotated[1], rotated[2]);
}

}  // namespace arcspan
