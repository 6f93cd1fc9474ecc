// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// u and v in one word of 64 bits, so that one addition steps both. From the top: the column of the texel in
/// `width_bits`, its fraction, the row of the texel in `height_bits`, its fraction of 32 bits. Both repeat by
/// wrapping; a carry of v changes the last fraction bit of u.
struct JoinedPoint {
  /// u and v as fractions of a repetition in 32 bits.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t of(std::uint32_t u, std::uint32_t v,
                                                                 unsigned height_bits) {
    const std::uint32_t unit = std::uint32_t{1} << height_bits;
    const std::uint64_t upper = std::uint64_t{u & (0u - unit)} << 32;
    // A product takes one instruction where a shift of two words takes five.
    return upper + (kHasLongMultiply && !kHasWideRegisters ? std::uint64_t{v} * unit
                                                           : std::uint64_t{v} << height_bits);
  }
  /// Signed changes of u and v.
  [[nodiscard]] ARCSPAN_INLINE static constexpr std::uint64_t step(std::int32_t u, std::int32_t v,
                                                                   unsigned height_bits) {
    // Rounded to what is left of u beside v.
    const std::uint32_t upper = static_cast<std::uint32_t>(u) + ((std::uint32_t{1} << height_bits) >> 1);
    return (std::uint64_t{upper >> height_bits << height_bits} << 32) +
           (static_cast<std::uint64_t>(std::int64_t{v}) << height_bits);
  }
};

}  // namespace arcspan
