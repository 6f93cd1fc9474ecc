// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>

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

/// The unit vector of a packed normal. Every bit pattern is valid; -32768 counts as -32767.
[[nodiscard]] Direction unpack_normal(PackedNormal packed);

}  // namespace arcspan
