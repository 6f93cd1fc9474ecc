// SPDX-License-Identifier: MIT
#include <arcspan/mesh/packed_normal.hpp>

namespace arcspan {

namespace {

std::int32_t scaled_to_one(std::int32_t c, std::int64_t sum) {
  const std::int64_t product = std::int64_t{c} * detail::kOctahedralOne;
  return static_cast<std::int32_t>((product >= 0 ? product + sum / 2 : product - sum / 2) / sum);
}

}  // namespace

PackedNormal pack_normal(std::int32_t x, std::int32_t y, std::int32_t z) {
  const std::int64_t sum = std::int64_t{detail::octahedral_magnitude(x)} + detail::octahedral_magnitude(y) +
                           detail::octahedral_magnitude(z);
  if (sum <= 0) return {};
  std::int32_t u = scaled_to_one(x, sum);
  std::int32_t v = scaled_to_one(y, sum);
  if (z < 0) detail::octahedral_fold(u, v);
  return {static_cast<std::int16_t>(u), static_cast<std::int16_t>(v)};
}

}  // namespace arcspan
