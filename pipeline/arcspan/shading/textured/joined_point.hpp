// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A level of light below v in a JoinedPoint: 0...64 with 11 fraction bits, in the 18 lowest bits. It is
/// added with its half, so that it is rounded when it is cut off, and rounding errors leave it positive.
struct JoinedLevel {
  static constexpr unsigned kBits = 18;
  static constexpr unsigned kFraction = 11;
  static constexpr unsigned kRoundedBits = 14;  ///< of a level with 25 fraction bits, in 32 bits
  static constexpr std::uint32_t kHalf = std::uint32_t{1} << (kFraction - 1);

  /// A change with 25 fraction bits, as one with 11.
  [[nodiscard]] static constexpr std::int32_t rounded(std::int32_t change) {
    return ((change >> (kRoundedBits - 1)) + 1) >> 1;
  }
};

/// u and v in one word of 64 bits, so that one addition steps both. From the top: the column of the texel in
/// `width_bits`, its fraction, the row of the texel in `height_bits`, its fraction of 32 bits. Both repeat by
/// wrapping; a carry of v changes the last fraction bit of u.
struct JoinedPoint {
  /// u and v as fractions of a repetition in 32 bits.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t joined(std::uint32_t u, std::uint32_t v,
                                                                     unsigned height_bits) {
    const std::uint32_t unit = std::uint32_t{1} << height_bits;
    const std::uint64_t upper = std::uint64_t{u & (0u - unit)} << 32;
    return upper + (kMultiplies ? std::uint64_t{v} * unit : std::uint64_t{v} << height_bits);
  }
  /// A change of u, rounded to what is left of u beside v.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::int32_t rounded(std::int32_t u, unsigned height_bits) {
    const std::uint32_t unit = std::uint32_t{1} << height_bits;
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(u) + (unit >> 1)) & (0u - unit));
  }
  /// Signed changes of u and v; that of u is rounded().
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t step(std::int32_t u, std::int32_t v,
                                                                   unsigned height_bits) {
    const std::uint64_t lower =
        kMultiplies ? static_cast<std::uint64_t>(std::int64_t{v} * (std::int32_t{1} << height_bits))
                    : static_cast<std::uint64_t>(std::int64_t{v}) << height_bits;
    return (std::uint64_t{static_cast<std::uint32_t>(u)} << 32) + lower;
  }

  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
    return a + b;
  }
  [[nodiscard]] static constexpr std::uint64_t negative(std::uint64_t a) { return 0 - a; }
  /// step * factor, which wraps; factor < 2^16.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t times(std::uint64_t step,
                                                                    std::uint32_t factor) {
    if constexpr (kHasLongMultiply) {
      return step * factor;
    } else {
      return static_cast<std::uint64_t>(detail::short_scaled(static_cast<std::int64_t>(step), factor));
    }
  }

 private:
  /// A product takes one instruction where a shift of two words takes five or more.
  static constexpr bool kMultiplies = kHasLongMultiply;
};

}  // namespace arcspan
