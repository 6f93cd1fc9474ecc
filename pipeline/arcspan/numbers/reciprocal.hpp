// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/leading_zeros.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A reciprocal 1/v = mantissa * 2^-exponent, mantissa in [2^15, 2^16].
struct Reciprocal {
  std::uint32_t mantissa;
  int exponent;  ///< 16...47

  /// The reciprocal with 47 fraction bits. With it, products are shifted by constants.
  [[nodiscard]] constexpr std::uint64_t fixed() const { return std::uint64_t{mantissa} << (47 - exponent); }
  /// Returns value / v with `bits` fraction bits, rounded down, for values below 2^15.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint32_t times(std::uint32_t value, int bits) const {
    if constexpr (kHasWideRegisters) return static_cast<std::uint32_t>((value * fixed()) >> (47 - bits));
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
[[nodiscard]] ARCSPAN_INLINE_AT_OS constexpr std::uint32_t reciprocal_mantissa(std::uint32_t normalised) {
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

/// nonzero_reciprocal() of v below 512, which needs no interpolation.
[[nodiscard]] ARCSPAN_INLINE_AT_OS constexpr Reciprocal short_reciprocal(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u);
  const std::uint32_t entry = detail::kReciprocalTable[((v << zeros) >> 23) & 0xFFu];
  return {(1u << 15) + entry, 16 + 31 - zeros};
}

namespace detail {

/// The reciprocals of short distances, for machines with wide registers: 4 KB.
inline constexpr std::size_t kShortDistances = kHasWideRegisters ? 512 : 0;
inline constexpr auto kShortReciprocals = [] {
  std::array<Reciprocal, kShortDistances> table{};
  for (std::size_t i = 0; i < kShortDistances; ++i)
    table[i] = nonzero_reciprocal(static_cast<std::uint32_t>(i));
  return table;
}();

}  // namespace detail

/// nonzero_reciprocal() of an edge's height in sixteenths; below 512 (32 rows) it is looked up on machines
/// with wide registers, which saves 18 instructions.
[[nodiscard]] ARCSPAN_INLINE_IF_WIDE constexpr Reciprocal distance_reciprocal(std::uint32_t v) {
  if constexpr (kHasWideRegisters) {
    if (v < detail::kShortDistances) [[likely]]
      return detail::kShortReciprocals[static_cast<std::size_t>(v)];
  }
  return nonzero_reciprocal(v);
}

/// The reciprocal of v as nonzero_reciprocal(); v = 0 counts as 1.
[[nodiscard]] constexpr Reciprocal reciprocal(std::uint32_t v) {
  return nonzero_reciprocal(v | static_cast<std::uint32_t>(v == 0));
}

namespace detail {

/// 1/n with 31 fraction bits, for n = normalised / 2^31 in [1, 2), by one Newton step in 32-bit products. `r`
/// is reciprocal_mantissa(normalised).
[[nodiscard]] constexpr std::uint32_t refined_mantissa(std::uint32_t normalised, std::uint32_t r) {
  // n r - 1 with 31 fraction bits, below 81700 in magnitude: the leading 1 is 2^31 and drops out.
  const std::uint32_t product = kHasLongMultiply
                                    ? static_cast<std::uint32_t>((std::uint64_t{normalised} * r) >> 16)
                                    : (normalised >> 16) * r + (((normalised & 0xFFFFu) * r) >> 16);
  const auto error = static_cast<std::int32_t>(product - (std::uint32_t{1} << 31));
  const std::int32_t correction = (error * static_cast<std::int32_t>(r >> 2)) >> 14;
  return (r << 15) - static_cast<std::uint32_t>(correction);
}
/// 1/n with 31 fraction bits, in [2^30, 2^31], for n = normalised / 2^31 in [1, 2).
[[nodiscard]] constexpr std::uint32_t wide_reciprocal_mantissa(std::uint32_t normalised) {
  return refined_mantissa(normalised, reciprocal_mantissa(normalised));
}

}  // namespace detail

/// The reciprocal of v, refined by one Newton step. Relative error at most 2^-28 (swept in the tests). v = 0
/// counts as 1.
[[nodiscard]] constexpr WideReciprocal wide_reciprocal(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u);
  const std::uint32_t normalised = (v | static_cast<std::uint32_t>(v == 0)) << zeros;
  return {detail::wide_reciprocal_mantissa(normalised), 31 + 31 - zeros};
}

}  // namespace arcspan
