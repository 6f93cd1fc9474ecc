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
  const std::int32_t whole = upper + below;  // 16 fraction bits
  const std::uint32_t low =
      (static_cast<std::uint32_t>(whole) << 16) | (lower_rest / static_cast<std::uint32_t>(divisor));
  return static_cast<std::int64_t>(
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(whole >> 16)) << 32) | low);
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
/// the divisor. Each digit of 10 or 11 bits is estimated with it by one 32-bit product, which is below 2^31
/// because dividend and divisor, and with them `rest`, are below 2^15. The estimate is wrong by at most 1,
/// that of the whole part by at most 2, and the remainder corrects it.
[[nodiscard]] constexpr std::int64_t divide_by_reciprocal(std::int32_t signed_dividend,
                                                          std::int32_t signed_divisor,
                                                          const Reciprocal& reciprocal) {
  const auto divisor = static_cast<std::uint32_t>(signed_divisor);
  auto rest = static_cast<std::uint32_t>(signed_dividend < 0 ? -signed_dividend : signed_dividend);
  const auto digit = [&](int bits) {
    std::uint32_t quotient = (rest * reciprocal.mantissa) >> (reciprocal.exponent - bits);
    rest = (rest << bits) - quotient * divisor;
    for (; static_cast<std::int32_t>(rest) < 0; rest += divisor) --quotient;
    for (; rest >= divisor; rest -= divisor) ++quotient;
    return quotient;
  };
  const std::uint32_t whole = rest < divisor ? 0 : digit(0);
  std::uint32_t fraction = digit(11);
  fraction = (fraction << 11) | digit(11);
  fraction = (fraction << 10) | digit(10);
  const auto quotient = static_cast<std::int64_t>((std::uint64_t{whole} << 32) | fraction);
  return signed_dividend < 0 ? -quotient - (rest != 0) : quotient;
}

}  // namespace detail

}  // namespace arcspan
