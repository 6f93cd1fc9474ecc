// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/root.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Normalising without a root and without a division.
///
/// The linear normal M = sum l_i M_i has the squared length 1 - e with
///
///     e = sum l_i (1 - |M_i|^2) + sum_{i<j} l_i l_j |M_i - M_j|^2,
///
/// a quadratic polynomial of the position on the screen, which is stepped by additions. A scalar of the
/// normalised normal is that of M times 1 / sqrt(1 - e), as in classic Phong shading.
namespace arcspan {

namespace detail {

/// 1 / sqrt(1 - i/64) - 1 with 30 fraction bits, for i = 0...48.
[[nodiscard]] consteval std::int64_t lengthening_at(std::int64_t i) {
  const std::uint64_t square = (std::uint64_t{1} << 63) / static_cast<std::uint64_t>(64 - i) << 3;
  return std::int64_t{wide_integer_root(square)} - (std::int64_t{1} << 30);
}

/// Entry i is the line through k at both ends of e = i/64 ... (i + 1)/64, as a function of s = e with 15
/// fraction bits: in the lower half of the word its slope, in the upper half its value at s = 0, so that the
/// sum below has 29 fraction bits. Up to e = 3/4 slopes fit 16 bits; beyond it k stays 1. The last entry is
/// for e slightly below 0, as rounding gives it at vertices.
[[nodiscard]] consteval std::array<std::uint32_t, 64> make_lengthening_table() {
  std::array<std::uint32_t, 64> table{};
  for (std::int64_t i = 0; i < 48; ++i) {
    const std::int64_t here = lengthening_at(i);
    const std::int64_t next = lengthening_at(i + 1);
    const std::int64_t slope =
        (next - here + (std::int64_t{1} << 9)) >> 10;  // 29 fraction bits per unit of s, which is 2^-15
    const std::int64_t at_zero = (here >> 1) - slope * (i << 9);
    const std::int64_t upper = (at_zero + (std::int64_t{1} << 15)) >> 16;
    table[static_cast<std::size_t>(i)] =
        (static_cast<std::uint32_t>(upper) << 16) | static_cast<std::uint32_t>(slope);
  }
  for (std::size_t i = 48; i < 63; ++i) table[i] = std::uint32_t{1} << 29;
  table[63] = table[0];
  return table;
}

inline constexpr std::array<std::uint32_t, 64> kLengtheningTable = make_lengthening_table();

}  // namespace detail

/// Returns k = 1 / sqrt(1 - e) - 1, 15 fraction bits, for e with 30 fraction bits, -1/64...63/64. Its error
/// is below 1.5 * 10^-4 for e in 0...1/3 (60 degrees), 2.2 * 10^-4 below 0 and 8 * 10^-4 up to 3/4, from
/// where on k is 1. Any other argument gives some k of -4...4.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t lengthening(std::int32_t e) {
  const std::uint32_t line = detail::kLengtheningTable[(static_cast<std::uint32_t>(e) >> 24) & 63u];
  const auto s = static_cast<std::uint32_t>(e >> 15);
  return static_cast<std::int32_t>(line + (line & 0xFFFFu) * s) >> 14;
}

/// Returns x (1 + k), for k of 0...1 with 15 fraction bits.
[[nodiscard]] ARCSPAN_INLINE constexpr Cosine lengthened(Cosine x, std::int32_t k) {
  return Cosine::from_raw(wrap_add(x.raw(), wrap_mul(x.raw() >> 15, k)));
}

}  // namespace arcspan
