// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/formats.hpp>

#include <cstdint>

namespace arcspan {

/// A unit vector that takes part in dot products: 15 fraction bits a component.
struct Direction {
  DirectionComponent x;
  DirectionComponent y;
  DirectionComponent z;

  friend constexpr bool operator==(const Direction&, const Direction&) = default;
};

/// A unit vector as vertices carry it: 14 fraction bits in 16-bit words, for the angles between normals.
struct Normal {
  NormalComponent x;
  NormalComponent y;
  NormalComponent z;

  friend constexpr bool operator==(const Normal&, const Normal&) = default;
};

[[nodiscard]] constexpr Direction operator-(const Direction& v) { return {-v.x, -v.y, -v.z}; }

/// a · b for unit vectors, in Q1.30 without rounding. By Cauchy's inequality no partial sum exceeds 1.
[[nodiscard]] constexpr Unit dot(const Direction& a, const Direction& b) {
  return multiply<Unit>(a.x, b.x) + multiply<Unit>(a.y, b.y) + multiply<Unit>(a.z, b.z);
}

[[nodiscard]] constexpr Normal to_normal(const Direction& v) {
  const auto narrow = [](DirectionComponent c) {
    return NormalComponent::from_raw(static_cast<std::int16_t>(round_shift(c.raw(), 1)));
  };
  return {narrow(v.x), narrow(v.y), narrow(v.z)};
}

/// |a - b|^2 = 2 - 2 a·b, from the difference vector: 2 - 2 a·b itself would lose a fifth of the value at an
/// angle of one degree (docs/papers.md). 0...4, with 28 fraction bits, unsigned.
[[nodiscard]] constexpr std::uint32_t squared_chord(const Normal& a, const Normal& b) {
  const std::int32_t x = std::int32_t{a.x.raw()} - b.x.raw();
  const std::int32_t y = std::int32_t{a.y.raw()} - b.y.raw();
  const std::int32_t z = std::int32_t{a.z.raw()} - b.z.raw();
  return static_cast<std::uint32_t>(wrap_add(wrap_add(wrap_mul(x, x), wrap_mul(y, y)), wrap_mul(z, z)));
}

/// The unit vector along (x, y, z), whatever its length; the zero vector gives the zero vector.
[[nodiscard]] Direction normalised(std::int32_t x, std::int32_t y, std::int32_t z);

/// The same for wider components, |component| < 2^62.
[[nodiscard]] Direction normalised_wide(std::int64_t x, std::int64_t y, std::int64_t z);

/// The unit vector half-way between two unit vectors (Blinn's H from L and V); zero if they are opposite.
[[nodiscard]] Direction half_way(const Direction& a, const Direction& b);

}  // namespace arcspan
