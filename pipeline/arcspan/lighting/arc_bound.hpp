// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Returns how far a scalar (the product of the normal and a fixed unit vector) may exceed the largest of its
/// values at the vertices of a triangle whose widest squared chord is s = `chord` (28 fraction bits, at most
/// 1): s/6 + 0.058 s^2, 30 fraction bits. The normals lie in a cap of the radius R, sin^2(R) <= s/3. The
/// result is at least 1 / cos(R) - 1 = s/6 + s^2/24 + ..., and therefore at least 1 - cos(R). Only for s
/// above 0.99 it may be smaller than the former, by less than 2^-13.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t cap_height(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;  // 15 fraction bits
  return static_cast<std::int32_t>(s * (5462u + ((s * 1901u) >> 15)));
}

}  // namespace arcspan::detail
