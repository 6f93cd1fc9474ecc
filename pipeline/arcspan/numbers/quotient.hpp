// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

/// A quotient with 32 fraction bits: upper * 2^-16 + lower * 2^-32. `exact` is true if the remainder is 0.
struct Quotient {
  std::uint32_t upper;
  std::uint32_t lower;
  bool exact;
};

/// Returns dividend / divisor, rounded down, by long division; both below 2^15, the divisor above 0.
[[nodiscard]] constexpr Quotient divide(std::uint32_t dividend, std::uint32_t divisor) {
  if constexpr (kHasWideRegisters) {
    const std::uint64_t whole = std::uint64_t{dividend} << 32;
    const std::uint64_t quotient = whole / divisor;
    return {static_cast<std::uint32_t>(quotient >> 16), static_cast<std::uint32_t>(quotient & 0xFFFFu),
            whole == quotient * divisor};
  }
  const std::uint32_t upper = (dividend << 16) / divisor;
  const std::uint32_t rest = ((dividend << 16) - upper * divisor) << 16;
  const std::uint32_t lower = rest / divisor;
  return {upper, lower, rest == lower * divisor};
}

/// Returns the quotient of divide() without a division instruction. `reciprocal` is nonzero_reciprocal() of
/// the divisor. Each 16-bit digit is estimated with the refined reciprocal; the estimate is wrong by at most
/// one, and the remainder corrects it.
[[nodiscard]] constexpr Quotient divide_by_reciprocal(std::uint32_t dividend, std::uint32_t divisor,
                                                      const Reciprocal& reciprocal) {
  const int zeros = 16 + 31 - reciprocal.exponent;
  const std::uint32_t inverse = refined_mantissa(divisor << zeros, reciprocal.mantissa);
  std::uint32_t rest = dividend;
  const auto digit = [&](int up) {
    // rest * 2^up / divisor = ((rest << (up + zeros - 16)) * inverse) >> 46; the last shift is in two parts.
    const std::uint32_t scaled_rest = rest << up;
    std::uint32_t quotient = multiply_high(scaled_rest << 1, inverse) >> (31 - zeros);
    rest = scaled_rest - quotient * divisor;
    if (static_cast<std::int32_t>(rest) < 0) {
      --quotient;
      rest += divisor;
    } else if (rest >= divisor) {
      ++quotient;
      rest -= divisor;
    }
    return quotient;
  };
  const std::uint32_t whole = dividend < divisor ? 0 : digit(0);
  const std::uint32_t upper = (whole << 16) | digit(16);
  const std::uint32_t lower = digit(16);
  return {upper, lower, rest == 0};
}

}  // namespace detail

}  // namespace arcspan
