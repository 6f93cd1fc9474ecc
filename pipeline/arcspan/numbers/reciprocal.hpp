// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A reciprocal 1/v = mantissa * 2^-exponent, mantissa in [2^15, 2^16].
struct Reciprocal {
  std::uint32_t mantissa;
  int exponent;  ///< 16...47

  /// Returns value / v with `bits` fraction bits, rounded down, for values below 2^15.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t times(std::uint32_t value, int bits) const {
    return (value * mantissa) >> (exponent - bits);
  }
};

/// A reciprocal 1/v = mantissa * 2^-exponent, mantissa in [2^30, 2^31].
struct WideReciprocal {
  std::uint32_t mantissa = 0;
  int exponent = 0;
};

namespace detail {

/// Entry i is 2^16 / (1 + i/256) - 2^15, rounded. Without the offset the first entry would need 17 bits.
consteval std::array<std::uint16_t, 257> make_reciprocal_table() {
  std::array<std::uint16_t, 257> table{};
  for (std::size_t i = 0; i <= 256; ++i) {
    const auto d = static_cast<std::uint32_t>(256 + i);
    table[i] = static_cast<std::uint16_t>(((std::uint32_t{1} << 24) + d / 2) / d - (1u << 15));
  }
  return table;
}

inline constexpr std::array<std::uint16_t, 257> kReciprocalTable = make_reciprocal_table();

/// 1/n with 16 fraction bits, in [2^15, 2^16], for n = normalised / 2^31 in [1, 2): bit 31 must be set.
[[nodiscard]] constexpr std::uint32_t reciprocal_mantissa(std::uint32_t normalised) {
  const std::size_t index = (normalised >> 23) & 0xFFu;
  const std::uint32_t fraction = (normalised >> 15) & 0xFFu;
  const std::uint16_t* const entry = &kReciprocalTable[index];
  const std::uint32_t above = entry[0];
  const std::uint32_t below = entry[1];
  return (1u << 15) + above - (((above - below) * fraction + 128u) >> 8);
}

}  // namespace detail

/// The reciprocal of v > 0 from a table of 257 entries with linear interpolation. Relative error at most
/// 3.8e-5 = 1.25 * 2^-15 (swept in the tests). For v = 0 the result is defined but meaningless.
[[nodiscard]] constexpr Reciprocal nonzero_reciprocal(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u);
  // v = n * 2^(31 - zeros) with n in [1, 2), 1/n = mantissa * 2^-16.
  return {detail::reciprocal_mantissa(v << zeros), 16 + 31 - zeros};
}

/// The reciprocal of v as nonzero_reciprocal(); v = 0 counts as 1.
[[nodiscard]] constexpr Reciprocal reciprocal(std::uint32_t v) {
  return nonzero_reciprocal(v | static_cast<std::uint32_t>(v == 0));
}

namespace detail {

/// 1/n with 31 fraction bits, in [2^30, 2^31], for n = normalised / 2^31 in [1, 2): reciprocal_mantissa()
/// after one Newton step in 32-bit products.
[[nodiscard]] constexpr std::uint32_t wide_reciprocal_mantissa(std::uint32_t normalised) {
  const std::uint32_t r = reciprocal_mantissa(normalised);
  // n r - 1 with 31 fraction bits, below 81700 in magnitude: the leading 1 is 2^31 and drops out.
  const std::uint32_t product = kHasLongMultiply
                                    ? static_cast<std::uint32_t>((std::uint64_t{normalised} * r) >> 16)
                                    : (normalised >> 16) * r + (((normalised & 0xFFFFu) * r) >> 16);
  const auto error = static_cast<std::int32_t>(product - (std::uint32_t{1} << 31));
  const std::int32_t correction = (error * static_cast<std::int32_t>(r >> 2)) >> 14;
  return (r << 15) - static_cast<std::uint32_t>(correction);
}

}  // namespace detail

/// The reciprocal of v, refined by one Newton step. Relative error at most 2^-28 (swept in the tests). v = 0
/// counts as 1.
[[nodiscard]] constexpr WideReciprocal wide_reciprocal(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u);
  const std::uint32_t normalised = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  return {detail::wide_reciprocal_mantissa(normalised), 31 + 31 - zeros};
}

namespace detail {

/// Returns dividend / divisor with 32 fraction bits, rounded down, by two 32-bit divisions. The divisor is
/// above 0 and, like the magnitude of the dividend, below 2^15.
[[nodiscard]] constexpr std::int64_t divide(std::int32_t dividend, std::int32_t divisor) {
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

/// Returns the quotient of divide() without a division instruction. `reciprocal` is nonzero_reciprocal() of
/// the divisor. Each digit of 10 or 11 bits is estimated with it by one 32-bit product, which is below 2^31
/// because dividend and divisor, and with them `rest`, are below 2^15. The estimate is wrong by at most 1,
/// that of the whole part by at most 2, and the remainder corrects it.
[[nodiscard]] constexpr std::int64_t divide_by_reciprocal(std::int32_t signed_dividend,
                                                          std::int32_t signed_divisor,
                                                          const Reciprocal& reciprocal) {
  const auto divisor = static_cast<std::uint32_t>(signed_divisor);
  std::uint32_t rest = magnitude(signed_dividend);
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
