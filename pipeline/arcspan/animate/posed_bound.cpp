// SPDX-License-Identifier: MIT
#include <arcspan/animate/posed_bound.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace {

/// Around all 16-bit positions: the root of 3 * 32768^2.
constexpr BoundingSphere kEverywhere{{0, 0, 0}, 56756};

/// The sphere around a box, whose vertices are saturated to 16 bits.
BoundingSphere sphere_around(const std::int32_t (&low)[3], const std::int32_t (&high)[3]) {
  std::int16_t middle[3];
  std::uint64_t square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t least = clamped_to_bits<16>(low[i]);
    const std::int32_t most = clamped_to_bits<16>(high[i]);
    middle[i] = static_cast<std::int16_t>((least + most) >> 1);
    const std::int64_t half = most - middle[i];  // the farther side
    square += static_cast<std::uint64_t>(half * half);
  }
  return {{middle[0], middle[1], middle[2]}, static_cast<std::uint16_t>(wide_integer_root(square) + 1)};
}

}  // namespace

BoundingSphere posed_bound(std::span<const JointBound> bounds, std::span<const JointMatrix> joints) {
  if (bounds.empty()) return kEverywhere;
  std::int32_t low[3] = {INT32_MAX, INT32_MAX, INT32_MAX};
  std::int32_t high[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
  for (const JointBound& bound : bounds) {
    if (bound.joint >= joints.size()) return kEverywhere;
    const JointMatrix& joint = joints[bound.joint];
    const ObjectPosition& p = bound.sphere.middle;
    for (std::size_t i = 0; i < 3; ++i) {
      // Rounded outwards by one unit, which is more than weights and rounding move a vertex.
      const std::int32_t place = joint.place(i, p.x, p.y, p.z) >> JointMatrix::kBits;
      const std::int32_t reach = joint.reach(i, bound.sphere.radius);
      if ((place < 0 ? -place : place) + reach >= JointMatrix::kFarthest) return kEverywhere;
      if (place - reach - 1 < low[i]) low[i] = place - reach - 1;
      if (place + reach + 2 > high[i]) high[i] = place + reach + 2;
    }
  }
  return sphere_around(low, high);
}

}  // namespace arcspan
