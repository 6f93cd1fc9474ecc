// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace arcspan {

/// 1/v as mantissa * 2^-exponent, mantissa in [2^15, 2^16].
struct Reciprocal {
  std::uint32_t mantissa = 0;
  int exponent = 0;
};

/// 1/v as mantissa * 2^-exponent, mantissa in [2^30, 2^31].
struct WideReciprocal {
  std::uint32_t mantissa = 0;
  int exponent = 0;
};

namespace detail {

/// Entry i is 2^16 / (1 + i/256) - 2^15, rounded; without the offset the first would need 17 bits.
consteval std::array<std::uint16_t, 257> make_reciprocal_table() {
  std::array<std::uint16_t, 257> table{};
  for (std::uint32_t i = 0; i <= 256; ++i) {
    const std::uint32_t d = 256 + i;
    table[i] = static_cast<std::uint16_t>(((1u << 24) + d / 2) / d - (1u << 15));
  }
  return table;
}

inline constexpr std::array<std::uint16_t, 257> kReciprocalTable = make_reciprocal_table();

/// Mantissa of the reciprocal of a number whose highest bit is bit 31.
[[nodiscard]] constexpr std::uint32_t reciprocal_mantissa(std::uint32_t normalised) {
  const std::uint32_t index = (normalised >> 23) & 0xFFu;
  const std::uint32_t fraction = (normalised >> 15) & 0xFFu;
  const std::uint32_t above = kReciprocalTable[index];
  const std::uint32_t below = kReciprocalTable[index + 1];
  return (1u << 15) + above - (((above - below) * fraction + 128u) >> 8);
}

}  // namespace detail

/// The reciprocal of v > 0 from a table of 257 entries with linear interpolation; relative error at most
/// 3.8e-5, 1.25 * 2^-15 (swept in the tests). v = 0 is taken as 1.
[[nodiscard]] constexpr Reciprocal reciprocal(std::uint32_t v) {
  const int zeros = std::countl_zero(v | 1u);
  // v = n * 2^(31 - zeros) with n in [1, 2), 1/n = mantissa * 2^-16.
  return {detail::reciprocal_mantissa((v | static_cast<std::uint32_t>(v == 0)) << zeros), 16 + 31 - zeros};
}

/// The reciprocal of v > 0, refined by one Newton step; relative error at most 2^-28 (swept in the tests).
/// v = 0 is taken as 1. Two 32x32->64 multiplies: for the vertex and preparation stages.
[[nodiscard]] constexpr WideReciprocal wide_reciprocal(std::uint32_t v) {
  const int zeros = std::countl_zero(v | 1u);
  const std::uint32_t n = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  const std::uint32_t r = detail::reciprocal_mantissa(n);  // 1/n, 16 fraction bits
  const std::uint64_t product = std::uint64_t{n} * r;      // n * r, 47 fraction bits
  const std::int64_t error = (std::int64_t{1} << 47) - static_cast<std::int64_t>(product);
  const std::int64_t correction = (error >> 16) * static_cast<std::int64_t>(r);  // 31 + 16 fraction bits
  const std::int64_t refined = (std::int64_t{r} << 15) + (correction >> 16);
  return {static_cast<std::uint32_t>(refined), 31 + 31 - zeros};
}

}  // namespace arcspan
