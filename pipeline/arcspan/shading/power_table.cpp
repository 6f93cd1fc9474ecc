// SPDX-License-Identifier: MIT
#include <arcspan/shading/power_table.hpp>

#include <bit>

namespace arcspan {

namespace {

/// base^exponent, 31 fraction bits, by square-and-multiply.
std::uint32_t power(std::uint32_t base, std::int32_t exponent) {
  std::uint64_t result = std::uint64_t{1} << 31;
  std::uint64_t square = base;
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = (result * square + (std::uint32_t{1} << 30)) >> 31;
    square = (square * square + (std::uint32_t{1} << 30)) >> 31;
  }
  return static_cast<std::uint32_t>(result);
}

/// Half the distance from 1 at which c^n falls to 2^-10, by bisection; 30 fraction bits.
std::uint32_t half_reach_of(std::int32_t exponent) {
  std::uint32_t reach = 0;
  for (std::uint32_t bit = std::uint32_t{1} << 28; bit != 0; bit >>= 1) {
    const std::uint32_t further = reach + bit;
    if (power((std::uint32_t{1} << 31) - 4 * further, exponent) >= std::uint32_t{1} << 21) reach = further;
  }
  return reach + 1;
}

}  // namespace

PowerTable::PowerTable(std::int32_t exponent) {
  const std::int32_t n = exponent < 1 ? 1 : exponent > kMaxExponent ? kMaxExponent : exponent;
  const std::uint32_t reach = half_reach_of(n);
  half_reach_ = static_cast<std::int32_t>(reach);
  const auto bits = static_cast<std::uint32_t>(std::bit_width(reach));
  drop_ = bits > 16 ? bits - 16 : 0;
  scale_ = ((kIntervals << 8) << 16) / ((reach >> drop_) + 1);
  for (std::size_t i = 0; i < kIntervals + 2; ++i) {
    // The half distance that position i << 8 stands for, times 4: 1 - c with 31 fraction bits.
    const std::uint64_t distance = ((std::uint64_t{i} << (8 + 16 + 2)) << drop_) / scale_;
    const std::uint64_t base = distance < (std::uint64_t{1} << 31) ? (std::uint64_t{1} << 31) - distance : 0;
    values_[i] = static_cast<std::uint16_t>((power(static_cast<std::uint32_t>(base), n) + (1u << 15)) >> 16);
  }
}

}  // namespace arcspan
