// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Raw value of the largest gradient, 2^16 per pixel or row. A steeper one only occurs in triangles narrower
/// than a pixel, whose spans have one pixel and do not step. For FullLinear it is 32 less, so that the
/// gradient still fits after FineRgb has rounded it to a multiple of 32.
template <class Value>
inline constexpr std::int32_t kMaxGradient = static_cast<std::int32_t>((std::int64_t{1}
                                                                        << (16 + Value::kFraction)) -
                                                                       (Value::kFraction < 15 ? 0 : 32));

namespace detail {

/// Returns product / 2^shift, rounded and saturated at +-most; `shift` is -16...30.
ARCSPAN_COLD_OUTLINE [[nodiscard]] constexpr std::int32_t steep_gradient(std::int32_t product, int shift,
                                                                         std::int32_t most) {
  const std::int32_t quotient = shift < 1 ? product : ((product >> (shift - 1)) + 1) >> 1;
  const std::int32_t limit = shift < 0 ? most >> -shift : most;
  if (quotient > limit) return most;
  if (quotient < -limit) return -most;
  return shift < 0 ? wrap_shl(quotient, -shift) : quotient;
}

}  // namespace detail

/// gradient() by one long product, which is shifted by a constant.
template <class Value>
[[nodiscard]] ARCSPAN_INLINE constexpr Value long_gradient(std::int32_t difference, const Reciprocal& inverse,
                                                           int bits) {
  constexpr std::int64_t kMost = kMaxGradient<Value>;
  const auto factor =
      static_cast<std::int64_t>(std::uint64_t{inverse.mantissa >> 1} << (47 - inverse.exponent));
  const int down = 46 - bits - Value::kFraction;
  const std::int64_t rounded = (difference * factor + (std::int64_t{1} << (down - 1))) >> down;
  // One test of the upper bits: no gradient below a power of two up to kMost is too large.
  constexpr int kFlatBits = Value::kFraction < 15 ? 16 + Value::kFraction : 30;
  const auto above_least = static_cast<std::uint64_t>(rounded + (std::int64_t{1} << kFlatBits));
  if ((above_least >> (kFlatBits + 1)) != 0) [[unlikely]] {
    if (rounded > kMost) return Value::from_raw(static_cast<std::int32_t>(kMost));
    if (rounded < -kMost) return Value::from_raw(static_cast<std::int32_t>(-kMost));
  }
  return Value::from_raw(static_cast<std::int32_t>(rounded));
}

/// Returns difference / distance, a gradient per pixel or row, saturated at +-kMaxGradient. `difference` is
/// that of two 16-bit attributes, |difference| < 2^16; `inverse` is the reciprocal of the distance, which has
/// `bits` fraction bits.
template <class Value>
[[nodiscard]] constexpr Value gradient(std::int32_t difference, const Reciprocal& inverse, int bits) {
  if constexpr (kHasWideRegisters) return long_gradient<Value>(difference, inverse, bits);
  // 1/distance = mantissa * 2^(bits - exponent); the product with a 15-bit mantissa fits 32 bits. From the
  // shift kFlat on, which a distance of at least 1 has, no quotient exceeds the largest gradient.
  constexpr int kFlat = Value::kFraction < 15 ? 15 - Value::kFraction : 1;
  const std::int32_t product = wrap_mul(difference, static_cast<std::int32_t>(inverse.mantissa >> 1));
  const int shift = inverse.exponent - 1 - bits - Value::kFraction;
  if (shift < kFlat) [[unlikely]] {
    return Value::from_raw(detail::steep_gradient(product, shift, kMaxGradient<Value>));
  }
  return Value::from_raw(((product >> (shift - 1)) + 1) >> 1);  // rounds without overflow
}

}  // namespace arcspan
