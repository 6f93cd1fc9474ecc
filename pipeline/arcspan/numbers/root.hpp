// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace arcspan {

/// floor(sqrt(v)), exact for every v. One bit a step: for object set-up, not for pixels.
[[nodiscard]] constexpr std::uint32_t integer_root(std::uint32_t v) {
  std::uint32_t root = 0;
  for (std::uint32_t bit = 1u << 30; bit != 0; bit >>= 2) {
    if (v >= root + bit) {
      v -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return root;
}

/// 1/sqrt(v) as mantissa * 2^-exponent, mantissa in [2^15, 2^16].
struct ReciprocalRoot {
  std::uint32_t mantissa = 0;
  int exponent = 0;
};

/// The reciprocal root of v > 0, relative error at most 2^-15 (swept in the tests); v = 0 is taken as 1.
/// A quadratic start (error 2^-5) and two Newton steps y <- y + y (1 - n y^2) / 2, the second with wide
/// products.
[[nodiscard]] constexpr ReciprocalRoot reciprocal_root(std::uint32_t v) {
  const int zeros = std::countl_zero(v | 1u) & ~1;
  // v = n * 2^(32 - zeros) with n in [1/4, 1); `n32` and `n` hold it with 32 and 16 fraction bits.
  const std::uint32_t n32 = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  const std::uint32_t n = n32 >> 16;
  // Minimax fit of 1/sqrt(n) on [1/4, 1]: 2.67083 - 3.28537 n + 1.63861 n^2, 14 fraction bits.
  std::uint32_t y = 43759u - ((53828u * n) >> 16) + ((26847u * ((n * n) >> 16)) >> 16);
  const std::uint32_t product = (n * ((y * y) >> 15)) >> 15;                    // n y^2, 14 fraction bits
  y = (y * (49152u - product) + (1u << 13)) >> 14;                              // 15 fraction bits
  const std::int64_t square = static_cast<std::int64_t>(std::uint64_t{y} * y);  // 30 fraction bits
  const std::int64_t error = (std::int64_t{1} << 30) - ((square * n32) >> 32);  // 1 - n y^2
  const std::int64_t refined = y + ((y * error + (std::int64_t{1} << 30)) >> 31);
  return {static_cast<std::uint32_t>(refined > 65536 ? 65536 : refined), 15 + 16 - zeros / 2};
}

}  // namespace arcspan
