// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A unit normal in 4 bytes: its coordinates in the octahedral map (Meyer et al., "On Floating-Point Normal
/// Vectors", 2010), two 16-bit signed fractions, raw / 32767. A normal that is packed and unpacked changes by
/// at most 0.006 degrees.
struct PackedNormal {
  std::int16_t u = 0;
  std::int16_t v = 0;

  friend constexpr bool operator==(const PackedNormal&, const PackedNormal&) = default;
};

/// The packed direction of (x, y, z), a vector of any length with |component| <= 2^30. The zero vector is
/// packed as +z.
[[nodiscard]] PackedNormal pack_normal(std::int32_t x, std::int32_t y, std::int32_t z);

namespace detail {

inline constexpr std::int32_t kOctahedralOne = 32767;

[[nodiscard]] constexpr std::int32_t octahedral_magnitude(std::int32_t v) {
  return v < 0 ? wrap_sub(0, v) : v;
}

/// Mirrors (u, v) at the line |u| + |v| = 1 of its quadrant, where the octahedral map keeps directions with
/// z < 0. Twice is the identity.
constexpr void octahedral_fold(std::int32_t& u, std::int32_t& v) {
  const std::int32_t folded_u = kOctahedralOne - octahedral_magnitude(v);
  const std::int32_t folded_v = kOctahedralOne - octahedral_magnitude(u);
  u = u < 0 ? -folded_u : folded_u;
  v = v < 0 ? -folded_v : folded_v;
}

/// A vector along a normal, |x| + |y| + |z| = kOctahedralOne.
struct OctahedralPoint {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

/// The point of a packed normal on the octahedron |x| + |y| + |z| = kOctahedralOne, or with `Down` bits less.
/// The sum is up to 4 more where u or v is -32768, which pack_normal() never writes, or rounded down to it.
template <int Down = 0>
[[nodiscard]] ARCSPAN_INLINE constexpr OctahedralPoint octahedral_point(PackedNormal packed) {
  const auto with_sign = [](std::int32_t size, std::int32_t sign) { return (size ^ sign) - sign; };
  std::int32_t x = packed.u >> Down;
  std::int32_t y = packed.v >> Down;
  const std::int32_t size_x = with_sign(x, x >> 31);
  const std::int32_t size_y = with_sign(y, y >> 31);
  const std::int32_t z = (kOctahedralOne >> Down) - size_x - size_y;
  if (z < 0) {  // as octahedral_fold() does
    x = with_sign(size_x + z, x >> 31);
    y = with_sign(size_y + z, y >> 31);
  }
  return {x, y, z};
}

}  // namespace detail

/// The unit vector of a packed normal. Every bit pattern is valid; -32768 counts as -32767.
[[nodiscard]] ARCSPAN_OUTLINE_IF_TIGHT inline Direction unpack_normal(PackedNormal packed) {
  constexpr std::int32_t kOne = detail::kOctahedralOne;
  std::int32_t x = packed.u < -kOne ? -kOne : packed.u;
  std::int32_t y = packed.v < -kOne ? -kOne : packed.v;
  const std::int32_t z = kOne - detail::octahedral_magnitude(x) - detail::octahedral_magnitude(y);
  if (z < 0) detail::octahedral_fold(x, y);
  // |x| + |y| + |z| = 1 implies 1/3 <= x^2 + y^2 + z^2 <= 1, so the root needs no scaling before.
  const auto square = static_cast<std::uint32_t>(x * x + y * y + z * z);
  const auto length = static_cast<std::int32_t>(detail::reciprocal_root_mantissa(square << 2));
  const auto unit = [length](std::int32_t c) {
    return DirectionComponent::from_raw(round_shift(c * length, 15));
  };
  return {unit(x), unit(y), unit(z)};
}

}  // namespace arcspan
