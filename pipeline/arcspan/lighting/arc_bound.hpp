// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Returns a lower bound of a highlight's half distance (PowerTable) on the arc between two normals, from
/// those at both; `angle2` is the squared angle between the normals.
///
/// On an arc of the angle psi the half distance is a cosine of 2 psi with the amplitude 1/2 at most (R·V;
/// N·H: less). Its second derivative by the angle is at most 2, so that it is below the chord by at most v (1
/// - v) psi^2, and below the lesser end by a quarter of what psi^2 exceeds the difference of the ends.
[[nodiscard]] constexpr std::int32_t nearest_between(std::int32_t at_a, std::int32_t at_b, Factor angle2) {
  const std::int32_t difference = at_a < at_b ? wrap_sub(at_b, at_a) : wrap_sub(at_a, at_b);
  const std::int32_t excess = wrap_sub(wrap_shl(angle2.raw(), 15), difference);
  constexpr std::int32_t kOfParabola = std::int32_t{1} << 21;  // for the error of the parabola that is drawn
  return wrap_sub(at_a < at_b ? at_a : at_b, (excess < 0 ? 0 : excess >> 2) + kOfParabola);
}

}  // namespace arcspan::detail
