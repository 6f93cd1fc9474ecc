// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

inline constexpr std::array<std::uint8_t, 256> kByteLeadingZeros = [] {
  std::array<std::uint8_t, 256> zeros{};
  for (std::size_t i = 0; i < 256; ++i) {
    zeros[i] = static_cast<std::uint8_t>(std::countl_zero(static_cast<std::uint32_t>(i)));
  }
  return zeros;
}();

[[nodiscard]] ARCSPAN_INLINE constexpr int leading_zeros_by_table(std::uint32_t v) {
  const int above = v < 0x10000u ? (v < 0x100u ? 0 : 8) : v < 0x1000000u ? 16 : 24;
  return kByteLeadingZeros[static_cast<std::size_t>(v >> above)] - above;
}

}  // namespace detail

/// std::countl_zero(v), from a table on RISC-V without Zbb unless optimised for size.
[[nodiscard]] ARCSPAN_INLINE constexpr int leading_zeros(std::uint32_t v) {
  if constexpr (kCountsLeadingZeros || kOptimisedForSize) {
    return std::countl_zero(v);
  } else {
    return detail::leading_zeros_by_table(v);
  }
}

}  // namespace arcspan
