// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Saturates coordinates to 16 bits.
ARCSPAN_OUTLINE ARCSPAN_COLD inline void saturate(ObjectPosition& position, std::int32_t x, std::int32_t y,
                                                  std::int32_t z) {
  const auto saturated = [](std::int32_t c) { return static_cast<std::int16_t>(clamped_to_bits<16>(c)); };
  position = {saturated(x), saturated(y), saturated(z)};
}

/// Coordinates saturated to 16 bits, with one test where none is. A function of its own saturates: if gcc
/// sees the bounds, it multiplies what is computed from the position in 64 bits.
[[nodiscard]] ARCSPAN_INLINE inline ObjectPosition saturated_position(std::int32_t x, std::int32_t y,
                                                                      std::int32_t z) {
  const auto above = [](std::int32_t c) { return static_cast<std::uint32_t>(c) + 32768u; };
  ObjectPosition position{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                          static_cast<std::int16_t>(z)};
  if ((above(x) | above(y) | above(z)) >= 65536u) [[unlikely]]
    saturate(position, x, y, z);
  return position;
}

}  // namespace arcspan::detail
