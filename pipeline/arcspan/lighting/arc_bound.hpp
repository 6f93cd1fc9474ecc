// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>

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

/// Returns an upper bound of a scalar over a triangle from its values c_i at the vertices; `chord` as above.
///
/// A normal inside is N = sum l_i N_i / w with l_i >= 0, sum l_i = 1 and w = |sum l_i N_i|. Let P be the sum
/// of l_i l_j over the edges, at most 1/3. Then w^2 >= 1 - s P, and because 1 / w is convex in P, it is at
/// most 1 + 3 P cap_height(). So the scalar is at most sum l_i c_i + 3 P cap_height(): the sum is at most 1,
/// and if it is negative, dividing by w <= 1 only lowers it. Let m be the largest c_i and m' the second one.
/// Then m - sum l_i c_i >= sum l_i l_j ((m - c_i) + (m - c_j)) >= P (m - m'), as one end of every edge has at
/// most m'. Since 3 P <= 1, the scalar exceeds m by at most cap_height() - (m - m') / 3, and not at all if
/// that is negative.
[[nodiscard]] constexpr Cosine highest_over(Cosine a, Cosine b, Cosine c, std::uint32_t chord) {
  const auto lesser = [](std::int32_t p, std::int32_t q) { return p < q ? p : q; };
  const auto greater = [](std::int32_t p, std::int32_t q) { return p > q ? p : q; };
  const std::int32_t of_two = greater(a.raw(), b.raw());
  const std::int32_t most = greater(of_two, c.raw());
  const std::int32_t second = lesser(of_two, greater(lesser(a.raw(), b.raw()), c.raw()));
  const std::int32_t quarter_gap = (most >> 2) - (second >> 2);  // the whole gap may overflow
  const std::int32_t above = cap_height(chord) - (quarter_gap + (quarter_gap >> 2));  // 5/16 < 1/3
  constexpr std::int32_t kRounding = std::int32_t{1} << 18;  // of packed normals, scalars and cap_height()
  return Cosine::from_raw(wrap_add(wrap_add(most, kRounding), greater(above, 0)));
}

}  // namespace arcspan::detail
