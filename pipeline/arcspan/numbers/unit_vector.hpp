// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// `v` scaled to length 1, with 30 fraction bits; the components are within 3 * 2^-30 of the exact ones and
/// below 2^62 in magnitude before. The zero vector gives the zero vector. It takes a 64-bit root and `Count`
/// 64-bit divisions: for cameras and rotations, where normalised() is too coarse.
template <std::size_t Count>
[[nodiscard]] ARCSPAN_OUTLINE constexpr std::array<std::int32_t, Count> unit_vector30(
    const std::array<std::int64_t, Count>& v) {
  static_assert(Count <= 4);
  std::uint64_t bits = 0;
  for (const std::int64_t c : v) bits |= magnitude(c);
  std::array<std::int32_t, Count> unit{};
  if (bits == 0) return unit;
  // The largest component gets 31 bits, so that the sum of four squares fits 64 bits.
  const int up = 31 - static_cast<int>(std::bit_width(bits));
  std::array<std::uint64_t, Count> scaled{};
  std::uint64_t square = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    scaled[i] = up >= 0 ? magnitude(v[i]) << up : magnitude(v[i]) >> -up;
    square += scaled[i] * scaled[i];
  }
  const std::uint64_t length = wide_integer_root(square);
  for (std::size_t i = 0; i < Count; ++i) {
    const auto size = static_cast<std::int32_t>(((scaled[i] << 30) + length / 2) / length);
    unit[i] = v[i] < 0 ? -size : size;
  }
  return unit;
}

/// True if all components are 0. Comparing arrays would call memcmp.
template <std::size_t Count>
[[nodiscard]] constexpr bool is_zero(const std::array<std::int32_t, Count>& v) {
  std::int32_t bits = 0;
  for (const std::int32_t c : v) bits |= c;
  return bits == 0;
}

}  // namespace arcspan
