// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// A coordinate saturated to 16 bits. A function of its own: if gcc sees the bounds, it multiplies what is
/// computed from the position in 64 bits.
[[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD inline std::int32_t saturated_coordinate(std::int32_t c) {
  return clamped_to_bits<16>(c);
}

/// Coordinates without their `Down` fraction bits, saturated to 16 bits: one test if none is.
template <int Down = 0>
[[nodiscard]] ARCSPAN_INLINE inline ObjectPosition saturated_position(std::int32_t x, std::int32_t y,
                                                                      std::int32_t z) {
  x >>= Down;
  y >>= Down;
  z >>= Down;
  const auto above = [](std::int32_t c) { return static_cast<std::uint32_t>(c) + 32768u; };
  if ((above(x) | above(y) | above(z)) >= 65536u) [[unlikely]] {
    x = saturated_coordinate(x);
    y = saturated_coordinate(y);
    z = saturated_coordinate(z);
  }
  return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)};
}

}  // namespace arcspan::detail
