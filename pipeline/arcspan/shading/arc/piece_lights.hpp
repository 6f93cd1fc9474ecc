// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/arc_bound.hpp>
#include <arcspan/shading/arc/row_pieces.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Which lights reach a piece of a row, and whose highlights do; for one light or several grey ones (decision
/// 28).
struct PieceLights {
  bool throughout;        ///< every light reaches all of the piece or nothing of it; always so for one light
  std::uint32_t lit;      ///< bit i: light i reaches it
  std::size_t shining;    ///< number of lights whose highlight is within reach
  std::size_t highlight;  ///< the last of those; 0 if there is none
};

/// Returns the PieceLights of a piece with these ends; highlights are within reach if their half distance is
/// below `reach`. N·L that has one sign at both ends has it between them, too.
template <class Lighting, std::size_t Count>
[[nodiscard]] ARCSPAN_INLINE constexpr PieceLights lights_of_piece(const Lighting& lighting,
                                                                   const RowEnds<Count>& ends,
                                                                   std::int32_t reach) {
  PieceLights lights{true, 0, 0, 0};
  for (std::size_t i = 0; i < lighting.lights(); ++i) {
    const Cosine left = ends.left[i];
    const Cosine right = ends.right[i];
    if (left.raw() <= 0 && right.raw() <= 0) continue;
    if (lighting.lights() != 1 && (left.raw() | right.raw()) < 0) lights.throughout = false;
    lights.lit |= std::uint32_t{1} << i;
    const std::size_t other = Lighting::highlight_index(i);
    const std::int32_t nearest =
        detail::nearest_between(lighting.rough_half_distance(left, ends.left[other], i),
                                lighting.rough_half_distance(right, ends.right[other], i), ends.angle2);
    if (nearest >= reach) continue;
    ++lights.shining;
    lights.highlight = i;
  }
  return lights;
}

}  // namespace arcspan
