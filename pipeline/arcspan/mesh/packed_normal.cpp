// SPDX-License-Identifier: MIT
#include <arcspan/mesh/packed_normal.hpp>
#include <arcspan/numbers/root.hpp>

namespace arcspan {

namespace {

constexpr std::int32_t kOne = 32767;

std::int32_t magnitude(std::int32_t v) { return v < 0 ? wrap_sub(0, v) : v; }

/// Mirrors (u, v) at the line |u| + |v| = 1 of its quadrant, where the octahedral map keeps directions with
/// z < 0. Twice is the identity.
void fold(std::int32_t& u, std::int32_t& v) {
  const std::int32_t folded_u = kOne - magnitude(v);
  const std::int32_t folded_v = kOne - magnitude(u);
  u = u < 0 ? -folded_u : folded_u;
  v = v < 0 ? -folded_v : folded_v;
}

std::int32_t scaled_to_one(std::int32_t c, std::int64_t sum) {
  const std::int64_t product = std::int64_t{c} * kOne;
  return static_cast<std::int32_t>((product >= 0 ? product + sum / 2 : product - sum / 2) / sum);
}

}  // namespace

PackedNormal pack_normal(std::int32_t x, std::int32_t y, std::int32_t z) {
  const std::int64_t sum = std::int64_t{magnitude(x)} + magnitude(y) + magnitude(z);
  if (sum <= 0) return {};
  std::int32_t u = scaled_to_one(x, sum);
  std::int32_t v = scaled_to_one(y, sum);
  if (z < 0) fold(u, v);
  return {static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
}

Direction unpack_normal(PackedNormal packed) {
  std::int32_t x = packed.u < -kOne ? -kOne : packed.u;
  std::int32_t y = packed.v < -kOne ? -kOne : packed.v;
  const std::int32_t z = kOne - magnitude(x) - magnitude(y);
  if (z < 0) fold(x, y);
  // |x| + |y| + |z| = 1 implies 1/3 <= x^2 + y^2 + z^2 <= 1, so the root needs no scaling before.
  const auto square = static_cast<std::uint32_t>(x * x + y * y + z * z);
  const auto length = static_cast<std::int32_t>(detail::reciprocal_root_mantissa(square << 2));
  const auto unit = [length](std::int32_t c) {
    return DirectionComponent::from_raw(round_shift(c * length, 15));
  };
  return {unit(x), unit(y), unit(z)};
}

}  // namespace arcspan
