// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/sine_table.hpp>

#include <array>
#include <cstdint>

namespace arcspan {

/// Polar coordinates: (x, y) = size * (cos angle, sin angle).
struct Polar {
  std::int32_t size;  ///< in the units of x and y, not negative
  Angle32 angle;
};

namespace detail {

inline constexpr int kCordicSteps = 20;

/// Entry i is atan(2^-i) as an Angle32.
consteval std::array<std::uint32_t, kCordicSteps> make_cordic_table() {
  std::array<std::uint32_t, kCordicSteps> table{};
  constexpr double kPerRadian = 0x1p31 / 3.14159265358979323846;
  table[0] = kQuarterTurn / 2;
  double x = 0.5;
  for (std::size_t i = 1; i < kCordicSteps; ++i, x /= 2) {
    double power = x;
    double sum = 0;
    for (int k = 0; k < 40; ++k, power *= -x * x) sum += power / (2 * k + 1);
    table[i] = static_cast<std::uint32_t>(sum * kPerRadian + 0.5);
  }
  return table;
}

inline constexpr std::array<std::uint32_t, kCordicSteps> kCordicTable = make_cordic_table();

}  // namespace detail

/// The polar coordinates of (x, y), |x|, |y| <= 2^29. The angle's error is at most 2^-18 rad where the size
/// exceeds 2^24; the size's error is at most 2^-20 of the size plus 20 units (swept in the tests). By
/// Volder's CORDIC (1959) in vectoring mode: shifts and additions, no root and no division.
[[nodiscard]] constexpr Polar to_polar(std::int32_t x, std::int32_t y) {
  Angle32 angle = 0;
  if (x < 0) {
    x = wrap_sub(0, x);
    y = wrap_sub(0, y);
    angle = 2 * kQuarterTurn;
  }
  for (int i = 0; i < detail::kCordicSteps; ++i) {
    const std::int32_t dx = y >> i;
    const std::int32_t dy = x >> i;
    const Angle32 turn = detail::kCordicTable[static_cast<std::size_t>(i)];
    if (y > 0) {
      x = wrap_add(x, dx);
      y = wrap_sub(y, dy);
      angle += turn;
    } else {
      x = wrap_sub(x, dx);
      y = wrap_add(y, dy);
      angle -= turn;
    }
  }
  constexpr std::int64_t kGain = 652032874;  // 0.607252935, 30 fraction bits
  return {static_cast<std::int32_t>((x * kGain + (std::int32_t{1} << 29)) >> 30), angle};
}

}  // namespace arcspan
