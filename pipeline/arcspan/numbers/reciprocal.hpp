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
  for (std::size_t i = 0; i <= 256; ++i) {
    const auto d = static_cast<std::uint32_t>(256 + i);
    table[i] = static_cast<std::uint16_t>(((std::uint32_t{1} << 24) + d / 2) / d - (1u << 15));
  }
  return table;
}

inline constexpr std::array<std::uint16_t, 257> kReciprocalTable = make_reciprocal_table();

/// Mantissa of the reciprocal of a number whose highest bit is bit 31.
[[nodiscard]] constexpr std::uint32_t reciprocal_mantissa(std::uint32_t normalised) {
  const std::size_t index = (normalised >> 23) & 0xFFu;
  const std::uint32_t fraction = (normalised >> 15) & 0xFFu;
  const std::uint32_t above = kReciprocalTable[index];
  const std::uint32_t below = kReciprocalTable[index + 1];
  return (1u << 15) + above - (((above - below) * fraction + 128u) >> 8);
}

}  // namespace detail

/// The reciprocal of v > 0 from a table of 257 entries with linear interpolation; relative error at most
/// 3.8e-5, 1.25 * 2^-15 (swept in the tests). For v = 0 something, but nothing undefined.
[[nodiscard]] constexpr Reciprocal nonzero_reciprocal(std::uint32_t v) {
  const int zeros = std::countl_zero(v | 1u);
  // v = n * 2^(31 - zeros) with n in [1, 2), 1/n = mantissa * 2^-16.
  return {detail::reciprocal_mantissa(v << zeros), 16 + 31 - zeros};
}

/// The same; v = 0 is taken as 1.
[[nodiscard]] constexpr Reciprocal reciprocal(std::uint32_t v) {
  return nonzero_reciprocal(v | static_cast<std::uint32_t>(v == 0));
}

namespace detail {

/// 1/n as mantissa * 2^-31 of n = normalised / 2^31 in [1, 2) from `r`, the same with 16 fraction bits as
/// reciprocal_mantissa() gives it: one Newton step in 32-bit products.
[[nodiscard]] constexpr std::uint32_t refined_mantissa(std::uint32_t normalised, std::uint32_t r) {
  // n r - 1 with 31 fraction bits, below 81700 in magnitude: the leading 1 is 2^31 and drops out.
  const std::uint32_t product = (normalised >> 16) * r + (((normalised & 0xFFFFu) * r) >> 16);
  const auto error = static_cast<std::int32_t>(product - (std::uint32_t{1} << 31));
  const std::int32_t correction = (error * static_cast<std::int32_t>(r >> 2)) >> 14;
  return (r << 15) - static_cast<std::uint32_t>(correction);
}
[[nodiscard]] constexpr std::uint32_t wide_reciprocal_mantissa(std::uint32_t normalised) {
  return refined_mantissa(normalised, reciprocal_mantissa(normalised));
}

}  // namespace detail

/// The reciprocal of v > 0, refined by one Newton step; relative error at most 2^-28 (swept in the tests).
/// v = 0 is taken as 1.
[[nodiscard]] constexpr WideReciprocal wide_reciprocal(std::uint32_t v) {
  const int zeros = std::countl_zero(v | 1u);
  const std::uint32_t normalised = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  return {detail::wide_reciprocal_mantissa(normalised), 31 + 31 - zeros};
}

}  // namespace arcspan
