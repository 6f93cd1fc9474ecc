// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Coordinates saturated to 16 bits, with one test where none is.
[[nodiscard]] ARCSPAN_INLINE inline ObjectPosition saturated_position(std::int32_t x, std::int32_t y,
                                                                      std::int32_t z) {
  const auto above = [](std::int32_t c) { return static_cast<std::uint32_t>(c) + 32768u; };
  if ((above(x) | above(y) | above(z)) >= 65536u) {
    x = clamped_to_bits<16>(x);
    y = clamped_to_bits<16>(y);
    z = clamped_to_bits<16>(z);
  }
  return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)};
}

}  // namespace arcspan::detail
