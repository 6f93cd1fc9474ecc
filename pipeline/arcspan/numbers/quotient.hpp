// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

/// divide() by two 32-bit divisions.
[[nodiscard]] constexpr std::int64_t divide_in_halves(std::int32_t dividend, std::int32_t divisor) {
  const std::int32_t upper = (dividend << 16) / divisor;
  const std::int32_t rest = (dividend << 16) - upper * divisor;
  const std::int32_t below = rest >> 31;  // -1 if the upper half was rounded up
  const auto lower_rest = static_cast<std::uint32_t>(rest + (divisor & below)) << 16;
  return (std::int64_t{upper + below} << 16) | (lower_rest / static_cast<std::uint32_t>(divisor));
}

/// Returns dividend / divisor with 32 fraction bits, rounded down. The divisor is above 0 and, like the
/// magnitude of the dividend, below 2^15.
[[nodiscard]] constexpr std::int64_t divide(std::int32_t dividend, std::int32_t divisor) {
  if constexpr (kHasWideRegisters) {
    const std::int64_t whole = std::int64_t{dividend} << 32;
    return whole / divisor + (whole % divisor >> 63);
  }
  return divide_in_halves(dividend, divisor);
}

/// Returns the quotient of divide() without a division instruction. `reciprocal` is nonzero_reciprocal() of
/// the divisor. Each 16-bit digit is estimated with the refined reciprocal; the estimate is wrong by at most
/// one, and the remainder corrects it.
[[nodiscard]] constexpr std::int64_t divide_by_reciprocal(std::int32_t signed_dividend,
                                                          std::int32_t signed_divisor,
                                                          const Reciprocal& reciprocal) {
  const auto dividend = static_cast<std::uint32_t>(signed_dividend < 0 ? -signed_dividend : signed_dividend);
  const auto divisor = static_cast<std::uint32_t>(signed_divisor);
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
  const auto quotient = static_cast<std::int64_t>((std::uint64_t{upper} << 16) | lower);
  return signed_dividend < 0 ? -quotient - (rest != 0) : quotient;
}

}  // namespace detail

}  // namespace arcspan
