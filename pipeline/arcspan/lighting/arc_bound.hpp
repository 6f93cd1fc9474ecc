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

/// Returns an upper bound of a scalar over a triangle from those at its vertices; `chord` is the widest
/// squared chord s between their normals, 28 fraction bits, at most 1.
///
/// A normal inside is N = sum l_i N_i / w, with w^2 >= 1 - s sum l_i l_j over the edges and sum l_i l_j <=
/// 1/3, so that 1 / w <= 1 + (s/2 + 0.174 s^2) sum l_i l_j. Let m be the largest scalar c_i and c the second
/// one. Since sum l_i (m - c_i) >= sum l_i l_j ((m - c_i) + (m - c_j)) >= (m - c) sum l_i l_j, the scalar
/// exceeds m by at most (s/2 + 0.174 s^2 - (m - c)) / 3, or not at all.
[[nodiscard]] constexpr Cosine highest_over(Cosine a, Cosine b, Cosine c, std::uint32_t chord) {
  const auto lesser = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
  const auto greater = [](std::int32_t p, std::int32_t q) { return p > q ? p : q; };
  const std::int32_t of_two = greater(a.raw(), b.raw());
  const std::int32_t most = greater(of_two, c.raw());
  const std::int32_t second = lesser(of_two, greater(lesser(a.raw(), b.raw()), c.raw()));
  const std::int32_t quarter = (most >> 2) - (second >> 2);
  const std::uint32_t s = chord >> 13;  // 15 fraction bits
  const std::uint32_t rise = s * (5462u + ((s * 1901u) >> 15));
  constexpr std::int32_t kRounding = std::int32_t{1} << 18;  // and the errors of patches and pieces
  const std::int32_t above = static_cast<std::int32_t>(rise) - (quarter + (quarter >> 2));  // 5/16 < 1/3
  return Cosine::from_raw(most + kRounding + greater(above, 0));
}

}  // namespace arcspan::detail
