// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed.hpp>
#include <arcspan/numbers/integer.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// floor(sqrt(v)), a step per bit of the root.
template <class Number>
[[nodiscard]] constexpr std::uint32_t root_by_bits(Number v) {
  Number root = 0;
  for (Number bit = Number{1} << (8 * sizeof(Number) - 2); bit != 0; bit >>= 2) {
    if (v >= root + bit) {
      v -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return static_cast<std::uint32_t>(root);
}

}  // namespace detail

/// floor(sqrt(v)), exact for every v. It takes 16 steps: fit for the set-up of objects, too slow for pixels.
[[nodiscard]] constexpr std::uint32_t integer_root(std::uint32_t v) { return detail::root_by_bits(v); }

/// floor(sqrt(v)), exact for every 64-bit v, in 32 steps.
[[nodiscard]] constexpr std::uint32_t wide_integer_root(std::uint64_t v) { return detail::root_by_bits(v); }

/// A reciprocal root 1/sqrt(v) = mantissa * 2^-exponent, mantissa in [2^15, 2^16].
struct ReciprocalRoot {
  std::uint32_t mantissa = 0;
  int exponent = 0;
};

namespace detail {

/// 1/sqrt(n) with 15 fraction bits, at most 2^16, for n = n32 / 2^32 in [1/4, 1). A quadratic polynomial
/// (error 2^-5), refined by two Newton steps y <- y + y (1 - n y^2) / 2.
[[nodiscard]] constexpr std::uint32_t reciprocal_root_mantissa(std::uint32_t n32) {
  const std::uint32_t n = n32 >> 16;
  // Minimax fit of 1/sqrt(n) on [1/4, 1]: 2.67083 - 3.28537 n + 1.63861 n^2, 14 fraction bits.
  std::uint32_t y = 43759u - ((53828u * n) >> 16) + ((26847u * ((n * n) >> 16)) >> 16);
  const std::uint32_t product = (n * ((y * y) >> 15)) >> 15;  // n y^2, 14 fraction bits
  y = (y * (49152u - product) + (1u << 13)) >> 14;            // 15 fraction bits
  // n y^2 with 28 fraction bits. y^2 reaches 4 only by rounding at n = 1/4, where it saturates.
  const std::uint32_t y2 = y > 65535 ? 0xFFFFFFFFu : y * y;
  const std::int32_t square =
      multiply_high(static_cast<std::int32_t>(y2 >> 1), static_cast<std::int32_t>(n32 >> 1));
  const std::int32_t error = (std::int32_t{1} << 28) - square;  // below 2^-8
  const std::uint32_t refined =
      y + static_cast<std::uint32_t>(round_shift(wrap_mul(static_cast<std::int32_t>(y), error >> 6), 23));
  return refined > 65536 ? 65536 : refined;
}

/// Entry i is 2^15 / sqrt((kFirstTabledRoot + i) / 128), rounded. The first would be 65536, which does not
/// fit 16 bits: it is 65535.
inline constexpr std::uint32_t kFirstTabledRoot = 32;
inline constexpr std::array<std::uint16_t, 98> kTabledRoots = [] {
  std::array<std::uint16_t, 98> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::uint32_t root = wide_integer_root((std::uint64_t{1} << 39) / (kFirstTabledRoot + i));
    table[i] = static_cast<std::uint16_t>((root + 1) / 2 - (i == 0));
  }
  return table;
}();

/// True for n = n30 / 2^30 in [1/4, 1 + 1/128).
[[nodiscard]] constexpr bool has_tabled_root(std::uint32_t n30) {
  return (n30 >> 23) - kFirstTabledRoot < kTabledRoots.size() - 1;
}
/// 1/sqrt(n) of such an n, 15 fraction bits, below 2^16: from the table with linear interpolation, with a
/// relative error of at most 2^-13 (swept in the tests). It takes 27 instructions fewer than
/// reciprocal_root_mantissa() on a Cortex-M3, 76 fewer on Armv6-M.
[[nodiscard]] constexpr std::uint32_t tabled_reciprocal_root(std::uint32_t n30) {
  const std::uint16_t* const entry = &kTabledRoots[static_cast<std::size_t>((n30 >> 23) - kFirstTabledRoot)];
  const std::uint32_t above = entry[0];
  const std::uint32_t below = entry[1];
  return above - (((above - below) * ((n30 >> 11) & 0xFFFu)) >> 12);
}

}  // namespace detail

/// The reciprocal root of v, relative error at most 2^-15 (swept in the tests). v = 0 counts as 1.
[[nodiscard]] constexpr ReciprocalRoot reciprocal_root(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u) & ~1;
  // v = n * 2^(32 - zeros) with n in [1/4, 1).
  const std::uint32_t n32 = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  return {detail::reciprocal_root_mantissa(n32), 15 + 16 - (zeros >> 1)};
}

}  // namespace arcspan
