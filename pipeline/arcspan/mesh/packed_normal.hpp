// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>

#include <cstdint>

namespace arcspan {

/// A unit normal in 4 bytes: the octahedral map (Meyer et al., "On Floating-Point Normal Vectors", 2010), two
/// 16-bit signed fractions (raw / 32767). Error of a packed and unpacked normal at most 0.006 degrees.
struct PackedNormal {
  std::int16_t u = 0;
  std::int16_t v = 0;

  friend constexpr bool operator==(const PackedNormal&, const PackedNormal&) = default;
};

/// Packs the direction of (x, y, z), whatever its length; |component| <= 2^30. The zero vector packs as +z.
[[nodiscard]] PackedNormal pack_normal(std::int32_t x, std::int32_t y, std::int32_t z);

/// The unit vector of a packed normal; every bit pattern is one.
[[nodiscard]] Direction unpack_normal(PackedNormal packed);

}  // namespace arcspan
