// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>

#include <cstdint>

namespace arcspan::detail {

/// Returns n / d, rounded, for d in 1...8160 and a quotient of at most 255: by a reciprocal, because the span
/// stage does not divide.
[[nodiscard]] constexpr std::uint32_t rounded_quotient(std::uint32_t n, std::uint32_t d,
                                                       const Reciprocal& of_d) {
  const std::uint32_t with_half = n + d / 2;
  const int dropped = of_d.exponent > 23 ? of_d.exponent - 23 : 0;  // 16 bits are left
  const std::uint32_t q = ((with_half >> dropped) * of_d.mantissa) >> (of_d.exponent - dropped);
  const auto rest = static_cast<std::int32_t>(with_half - q * d);
  if (rest < 0) return q - 1;
  return q + static_cast<std::uint32_t>(rest >= static_cast<std::int32_t>(d));
}

/// A pixel 0xAARRGGBB with a share of `share` / 32 of `other`, 0...32. Colours count as much as they are
/// opaque, and are not premultiplied.
[[nodiscard]] constexpr std::uint32_t blended_with_alpha(std::uint32_t pixel, std::uint32_t other,
                                                         std::uint32_t share) {
  const std::uint32_t a = (pixel >> 24) * (32 - share);
  const std::uint32_t b = (other >> 24) * share;
  const std::uint32_t alpha = ((a + b + 16) >> 5) << 24;
  if (b == 0) return alpha | (pixel & 0xFFFFFFu);
  if (a == 0) return alpha | (other & 0xFFFFFFu);
  const Reciprocal of_sum = nonzero_reciprocal(a + b);
  const auto mixed = [&](unsigned shift) {
    const std::uint32_t sum = a * ((pixel >> shift) & 255u) + b * ((other >> shift) & 255u);
    return rounded_quotient(sum, a + b, of_sum) << shift;
  };
  return alpha | mixed(16) | mixed(8) | mixed(0);
}

}  // namespace arcspan::detail
