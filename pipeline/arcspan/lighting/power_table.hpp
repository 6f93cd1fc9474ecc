// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// base^exponent for base in 0...1, both with 31 fraction bits, by square-and-multiply.
[[nodiscard]] constexpr std::uint32_t power_of(std::uint32_t base, std::int32_t exponent) {
  std::uint64_t result = std::uint64_t{1} << 31;
  std::uint64_t square = base;
  for (; exponent > 0; exponent >>= 1) {
    if ((exponent & 1) != 0) result = (result * square + (std::uint32_t{1} << 30)) >> 31;
    square = (square * square + (std::uint32_t{1} << 30)) >> 31;
  }
  return static_cast<std::uint32_t>(result);
}

/// (1 - c) / 2 of the cosine c with c^n = 2^-10, 30 fraction bits, found by bisection.
[[nodiscard]] constexpr std::uint32_t half_reach_of(std::int32_t exponent) {
  std::uint32_t reach = 0;
  for (std::uint32_t bit = std::uint32_t{1} << 28; bit != 0; bit >>= 1) {
    const std::uint32_t further = reach + bit;
    if (power_of((std::uint32_t{1} << 31) - 4 * further, exponent) >= std::uint32_t{1} << 21) {
      reach = further;
    }
  }
  return reach + 1;
}

}  // namespace detail

/// The power c^n of the specular factor, from a table over 1 - c with linear interpolation. The table covers
/// the cosines whose power exceeds 2^-10, a quarter of an 8-bit step; for smaller cosines the power counts as
/// 0. The table is over 1 - c because highlights need many significant bits near c = 1.
class PowerTable {
 public:
  static constexpr std::uint32_t kIntervals = 128;
  static constexpr std::int32_t kMaxExponent = 256;

  constexpr PowerTable() = default;

  /// The table of c^n; `exponent` is clamped to 1...256. The error is at most 6.9e-4 below half_reach()
  /// (2^-11 up to n = 16), and 2^-10 from there on, where the power counts as 0 (swept in the tests).
  constexpr explicit PowerTable(std::int32_t exponent) {
    const std::int32_t n = exponent < 1 ? 1 : exponent > kMaxExponent ? kMaxExponent : exponent;
    const std::uint32_t reach = detail::half_reach_of(n);
    half_reach_ = static_cast<std::int32_t>(reach);
    const auto bits = static_cast<std::uint32_t>(std::bit_width(reach));
    drop_ = bits > 16 ? bits - 16 : 0;
    scale_ = ((kIntervals << 8) << 16) / ((reach >> drop_) + 1);
    for (std::size_t i = 0; i < kIntervals + 2; ++i) {
      // 1 - c with 31 fraction bits: four times the half distance at position i << 8.
      const std::uint64_t distance = ((std::uint64_t{i} << (8 + 16 + 2)) << drop_) / scale_;
      const std::uint64_t base =
          distance < (std::uint64_t{1} << 31) ? (std::uint64_t{1} << 31) - distance : 0;
      values_[i] = static_cast<std::uint16_t>(
          (detail::power_of(static_cast<std::uint32_t>(base), n) + (1u << 15)) >> 16);
    }
  }

  /// The least (1 - c) / 2 for which the power counts as 0: 30 fraction bits, at most 2^29 + 1.
  [[nodiscard]] constexpr std::int32_t half_reach() const { return half_reach_; }

  /// c^n in 0...1, 15 fraction bits, for half_distance = (1 - c) / 2 with 30 fraction bits. It must be below
  /// half_reach(); a negative one, of a cosine that rounding has raised above 1, counts as 0.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t operator()(std::int32_t half_distance) const {
    const std::uint32_t distance = half_distance < 0 ? 0u : static_cast<std::uint32_t>(half_distance);
    const std::uint32_t position = ((distance >> drop_) * scale_) >> 16;  // 8 fraction bits
    const auto index = static_cast<std::size_t>(position >> 8);
    const std::uint32_t here = values_[index];
    const std::uint32_t next = values_[index + 1];
    return here - (((here - next) * (position & 0xFFu) + 128u) >> 8);
  }

 private:
  std::int32_t half_reach_ = 0;
  std::uint32_t drop_ = 0;   ///< shift that leaves 16 bits of a half distance below half_reach()
  std::uint32_t scale_ = 0;  ///< factor from those to a position in the table, 16 fraction bits
  std::array<std::uint16_t, kIntervals + 2> values_{};
};

}  // namespace arcspan
