// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// The factor k = 2 - 2 cos(phi) of an arc with steps of the angle phi, in block floating point:
/// k = mantissa * 2^-(16 + shift + fine). A k of 1/4 or more (28.9 degrees per step) saturates; it only
/// occurs where an arc has no second step to make.
struct RecurrenceStep {
  std::int32_t mantissa;  ///< 0...2^15 - 1; 0 makes the scalar linear
  std::int32_t shift;     ///< 1...31
  std::int32_t fine;      ///< fraction bits of differences beyond 30
};

/// A scalar that is stepped along an arc: S0 eq. 14 in Reinsch's difference form,
///
///     x <- x + d;    d <- d - round(k x)
///
/// A step takes one 16x16->32 multiply, one shift and three sums, one of which rounds. The multiplier gets
/// the top 16 bits of x (14 fraction bits); d keeps 30 fraction bits, because its error grows with the number
/// of steps (docs/papers.md).
struct RecurrenceScalar {
  Cosine x;
  Cosine d;

  /// Steps along an arc whose RecurrenceStep has no fine bits.
  constexpr void step(std::int32_t mantissa, std::int32_t shift) {
    x += d;
    const std::int32_t kx = wrap_mul(mantissa, x.raw() >> 16);
    d -= Cosine::from_raw(wrap_add(kx, std::int32_t{1} << (shift - 1)) >> shift);
  }

  /// Steps with a difference of 30 + fine fraction bits, for edges, which may have 2048 rows. The rounding
  /// error of k x hardly changes from one step to the next, so over m steps it adds up to m^2 / 4 units of d;
  /// the fine bits make that unit smaller.
  constexpr void fine_step(const RecurrenceStep& k) {
    x += Cosine::from_raw(d.raw() >> k.fine);
    const std::int32_t kx = wrap_mul(k.mantissa, x.raw() >> 16);
    d -= Cosine::from_raw(wrap_add(kx, std::int32_t{1} << (k.shift - 1)) >> k.shift);
  }
};

/// Returns k = phi^2 (1 - phi^2/12), phi^2 = a^2 psi^2, of an arc with the squared angle psi^2 = `angle2`
/// (`bits` fraction bits), of which one step is the fraction a = mantissa * 2^-exponent; mantissa in [2^15,
/// 2^16], exponent at least 16, so a <= 1. A k too small for its format becomes 0, a k of 1/4 or more
/// saturates.
[[nodiscard]] ARCSPAN_OUTLINE constexpr RecurrenceStep recurrence_step(std::int32_t angle2, int bits,
                                                                       std::uint32_t mantissa, int exponent,
                                                                       int fine) {
  // phi^2 = wide * 2^-(30 + scale), wide below 1.1 * 2^30.
  const std::uint32_t half = mantissa >> 1;
  const std::uint32_t once = (static_cast<std::uint32_t>(angle2) * half + (1u << 14)) >> 15;
  std::uint32_t wide = once * half;
  const int scale = 2 * (exponent - 16) + bits - 15;
  if (wide == 0) return {0, 31, fine};
  if (scale < 16) {
    const std::uint32_t phi2 = wide >> (15 + scale);  // 15 fraction bits
    wide -= (wide >> 15) * ((phi2 * 2731u) >> 15);    // phi^2 / 12
  }
  const int drop = 17 - std::countl_zero(wide);  // leaves 15 bits
  const int shift = 14 + scale - drop - fine;
  if (shift < 1) return {32767, 1, fine};
  if (shift > 31) return {0, 31, fine};
  return {static_cast<std::int32_t>(drop >= 0 ? wide >> drop : wide << -drop), shift, fine};
}

}  // namespace arcspan
