// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Products of a scalar with a fraction, and its quotients by lengths on the screen.
namespace arcspan::detail {

/// Returns v * f, rounded down, for f in 0...2. It keeps all 30 fraction bits by two products, because an
/// error in a part of a patch acts as an error of the normal's length, to which highlights are most
/// sensitive.
[[nodiscard]] constexpr Cosine part(Cosine v, Factor f) {
  return Cosine::from_raw(scaled_down(v.raw(), static_cast<std::uint32_t>(f.raw()), Factor::kFraction));
}

/// The inverse of a length in pixels or rows: fraction * 2^-down.
struct InverseLength {
  Factor fraction;
  int down;
};

/// Returns the inverse of a length of at least 1/2, given as the reciprocal of the length with `bits`
/// fraction bits.
[[nodiscard]] ARCSPAN_INLINE constexpr InverseLength inverse_length(const Reciprocal& inverse, int bits) {
  const int down = inverse.exponent - bits - 16;
  const std::uint32_t fraction = inverse.mantissa >> 1;
  if (down >= 0) return {Factor::from_raw(static_cast<std::int32_t>(fraction)), down};
  return {Factor::from_raw(static_cast<std::int32_t>(fraction << -down)), 0};
}

/// Returns v / length, rounded down.
[[nodiscard]] constexpr Cosine divide_by_length(Cosine v, const InverseLength& step) {
  return Cosine::from_raw(part(v, step.fraction).raw() >> step.down);
}

/// Returns v / (length of `one` * length of `other`), rounded to nearest. It makes differences of
/// differences, whose rounding error is summed twice.
[[nodiscard]] ARCSPAN_INLINE constexpr Cosine divide_by_both_lengths(Cosine v, const InverseLength& one,
                                                                     const InverseLength& other) {
  const Cosine product = part(part(v, one.fraction), other.fraction);
  const int down = one.down + other.down;  // of a patch at most 14, because it is at most kLargestPatch
  const std::int32_t half = (std::int32_t{1} << down) >> 1;
  return Cosine::from_raw(wrap_add(product.raw(), half) >> down);
}

}  // namespace arcspan::detail
