// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// a + b modulo 2^32, as wrap_sub(), wrap_mul() and wrap_shl() are modulo 2^32. Where the plain operation
/// does not overflow, the result is the same. Where it does, the result is wrong but defined; callers state
/// ranges in which it does not.
[[nodiscard]] constexpr std::int32_t wrap_add(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr std::int32_t wrap_sub(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr std::int32_t wrap_mul(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}
[[nodiscard]] constexpr std::int32_t wrap_shl(std::int32_t a, int bits) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) << bits);
}

/// |v|, also of the least number.
[[nodiscard]] constexpr std::uint32_t magnitude(std::int32_t v) {
  return v < 0 ? 0 - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
}
[[nodiscard]] constexpr std::uint64_t magnitude(std::int64_t v) {
  return v < 0 ? 0 - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v);
}

/// v >> Shift clamped to the range of unsigned integers of `Bits` bits. One instruction on processors that
/// saturate; one comparison on others, where nothing is clamped.
template <int Bits, int Shift>
[[nodiscard]] constexpr std::uint32_t clamped_unsigned(std::int32_t v) {
  static_assert(Bits > 0 && Bits < 32 && Shift >= 0 && Shift < 32);
  if constexpr (kHasSaturate) return saturated_unsigned<Bits, Shift>(v);
  constexpr std::uint32_t kMost = (std::uint32_t{1} << Bits) - 1;
  const auto shifted = static_cast<std::uint32_t>(v >> Shift);
  if (shifted > kMost) return v < 0 ? 0u : kMost;
  return shifted;
}

/// `v` clamped to the range of signed integers of `Bits` bits: one comparison where nothing is clamped.
template <int Bits>
[[nodiscard]] constexpr std::int32_t clamped_to_bits(std::int32_t v) {
  static_assert(Bits > 0 && Bits < 32);
  constexpr std::uint32_t kHalf = std::uint32_t{1} << (Bits - 1);
  if (static_cast<std::uint32_t>(v) + kHalf < 2 * kHalf) return v;
  return v < 0 ? -static_cast<std::int32_t>(kHalf) : static_cast<std::int32_t>(kHalf - 1);
}

/// `v` clamped to -most ... most.
template <class Number>
[[nodiscard]] constexpr std::int32_t limited(Number v, std::int32_t most) {
  if (v > most) return most;
  return v < -most ? -most : static_cast<std::int32_t>(v);
}

namespace detail {

/// multiply_high() by four products of 16-bit halves.
[[nodiscard]] constexpr std::uint32_t short_multiply_high(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t a1 = a >> 16;
  const std::uint32_t a0 = a & 0xFFFFu;
  const std::uint32_t b1 = b >> 16;
  const std::uint32_t b0 = b & 0xFFFFu;
  const std::uint32_t first = a1 * b0 + ((a0 * b0) >> 16);
  const std::uint32_t second = a0 * b1 + (first & 0xFFFFu);
  return a1 * b1 + (first >> 16) + (second >> 16);
}

/// Signed, from the unsigned product: reading a negative factor as unsigned adds 2^32 to it.
[[nodiscard]] constexpr std::int32_t short_multiply_high(std::int32_t a, std::int32_t b) {
  const std::uint32_t product =
      short_multiply_high(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  return wrap_sub(wrap_sub(static_cast<std::int32_t>(product), a < 0 ? b : 0), b < 0 ? a : 0);
}

/// scaled() by three products with `factor`.
[[nodiscard]] constexpr std::int64_t short_scaled(std::int64_t value, std::uint32_t factor) {
  const auto low = static_cast<std::uint32_t>(value);
  const auto high = static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32);
  const std::uint32_t first = (low & 0xFFFFu) * factor;
  const std::uint32_t second = (low >> 16) * factor + (first >> 16);
  const std::uint32_t third = high * factor + (second >> 16);
  return static_cast<std::int64_t>((std::uint64_t{third} << 32) | ((second << 16) | (first & 0xFFFFu)));
}

}  // namespace detail

/// floor(a * b / 2^32), exact.
[[nodiscard]] constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
  if constexpr (kHasLongMultiply) {
    return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32);
  } else {
    return detail::short_multiply_high(a, b);
  }
}
[[nodiscard]] constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
  if constexpr (kHasLongMultiply) {
    return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
  } else {
    return detail::short_multiply_high(a, b);
  }
}

/// a * b, exact, without the long routine for 64-bit products on Armv6-M.
[[nodiscard]] constexpr std::uint64_t wide_product(std::uint32_t a, std::uint32_t b) {
  if constexpr (kHasLongMultiply) return std::uint64_t{a} * b;
  return (std::uint64_t{multiply_high(a, b)} << 32) | (a * b);
}

/// floor(value * factor / 2^bits), of which the lower 32 bits are returned; factor in 0...2^16, bits
/// in 15...16.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t scaled_down(std::int32_t value, std::uint32_t factor,
                                                                int bits) {
  // For 16 bits the halves take as few instructions, because a product is added to another in one.
  if (kHasLongMultiply && bits < 16) {
    return static_cast<std::int32_t>((std::int64_t{value} * static_cast<std::int32_t>(factor)) >> bits);
  } else {
    const std::uint32_t low = (static_cast<std::uint32_t>(value) & ((std::uint32_t{1} << bits) - 1)) * factor;
    return wrap_add(wrap_mul(value >> bits, static_cast<std::int32_t>(factor)),
                    static_cast<std::int32_t>(low >> bits));
  }
}

/// base + scaled_down(value, factor, 16). Where a product has two words, each of its halves is shifted by the
/// addition that takes it.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t plus_scaled_down(std::int32_t base, std::int32_t value,
                                                                     std::uint32_t factor) {
  if constexpr (!kHasLongMultiply) {
    return wrap_add(base, scaled_down(value, factor, 16));
  } else {
    auto signed_factor = static_cast<std::int32_t>(factor);
    hide_value(signed_factor);  // gcc multiplies a signed by an unsigned number in three instructions
    const auto product = static_cast<std::uint64_t>(std::int64_t{value} * signed_factor);
    const std::uint32_t low = static_cast<std::uint32_t>(product) >> 16;
    const std::uint32_t high = static_cast<std::uint32_t>(product >> 32) << 16;
    return wrap_add(wrap_add(base, static_cast<std::int32_t>(low)), static_cast<std::int32_t>(high));
  }
}

/// value * factor, for factor < 2^16. The result must fit 64 bits.
[[nodiscard]] constexpr std::int64_t scaled(std::int64_t value, std::uint32_t factor) {
  if constexpr (kHasLongMultiply) {
    return value * static_cast<std::int64_t>(factor);
  } else {
    return detail::short_scaled(value, factor);
  }
}

namespace detail {

inline constexpr std::array<std::uint8_t, 256> kByteLeadingZeros = [] {
  std::array<std::uint8_t, 256> zeros{};
  for (std::size_t i = 0; i < 256; ++i) {
    zeros[i] = static_cast<std::uint8_t>(std::countl_zero(static_cast<std::uint32_t>(i)));
  }
  return zeros;
}();

[[nodiscard]] ARCSPAN_INLINE constexpr int leading_zeros_by_table(std::uint32_t v) {
  const int above = v < 0x10000u ? (v < 0x100u ? 0 : 8) : v < 0x1000000u ? 16 : 24;
  return kByteLeadingZeros[static_cast<std::size_t>(v >> above)] - above;
}

}  // namespace detail

/// std::countl_zero(v), from a table on RISC-V without Zbb unless optimised for size.
[[nodiscard]] ARCSPAN_INLINE constexpr int leading_zeros(std::uint32_t v) {
  if constexpr (kCountsLeadingZeros || kOptimisedForSize) {
    return std::countl_zero(v);
  } else {
    return detail::leading_zeros_by_table(v);
  }
}

}  // namespace arcspan
