// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// k = 2 - 2 cos(phi) of an arc's step phi, block-floating, for differences with 30 + fine fraction bits:
/// k = mantissa * 2^-(16 + shift + fine). A zero mantissa makes the step linear. mantissa < 2^15;
/// shift 1...31. A k of 1/4 (28.9 degrees a step) or more only occurs where an arc has no second step to
/// make, and saturates.
struct ArcStep {
  std::int32_t mantissa;
  std::int32_t shift;
  std::int32_t fine;
};

/// A scalar on its way along an arc: S0 eq. 14 in Reinsch's difference form,
///
///     x <- x + d;    d <- d - round(k x)
///
/// one 16x16->32 multiply, one shift, and sums. The multiplier sees the top 16 bits of x (14 fraction bits);
/// d keeps all 30, because its error grows with the number of steps (docs/papers.md).
struct ArcScalar {
  Cosine x;
  Cosine d;

  constexpr void step(std::int32_t mantissa, std::int32_t shift) {
    x += d;
    const std::int32_t kx = wrap_mul(mantissa, x.raw() >> 16);
    d -= Cosine::from_raw(wrap_add(kx, std::int32_t{1} << (shift - 1)) >> shift);
  }

  /// The same with a difference of 30 + fine fraction bits: over m steps the rounding of k x, which hardly
  /// changes from one to the next, adds up to m^2 / 4 units of d. For edges, which may have 2048 rows.
  constexpr void fine_step(const ArcStep& k) {
    x += Cosine::from_raw(d.raw() >> k.fine);
    const std::int32_t kx = wrap_mul(k.mantissa, x.raw() >> 16);
    d -= Cosine::from_raw(wrap_add(kx, std::int32_t{1} << (k.shift - 1)) >> k.shift);
  }
};

/// k of an arc whose squared angle is `angle2`, with `bits` fraction bits, and whose step is the fraction a =
/// mantissa * 2^-exponent of it, mantissa in [2^15, 2^16], exponent >= 16 (a <= 1): phi^2 = a^2 psi^2, k =
/// phi^2 (1 - phi^2/12).
[[nodiscard]] ARCSPAN_OUTLINE constexpr ArcStep arc_step(std::int32_t angle2, int bits,
                                                         std::uint32_t mantissa, int exponent, int fine) {
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

/// Turns k = 2 - 2 cos(phi) into that of twice the step, k(2 phi) = k (4 - k). `k` must have no fine bits.
/// False, with k as it was, if the doubled one is 1/4 or more, which ArcStep cannot hold: 28.9 degrees.
[[nodiscard]] constexpr bool double_stride(ArcStep& k) {
  // k = m 2^-(16 + s), so k (4 - k) = 2 (2 m - m^2 2^-(17 + s)) 2^-(16 + s).
  const auto m = static_cast<std::uint32_t>(k.mantissa);
  const std::int32_t down = 17 + k.shift;
  const std::uint32_t second_difference = down > 31 ? 0u : (m * m + (1u << (down - 1))) >> down;
  const std::uint32_t sum = 2 * m - second_difference;
  const bool sixteen_bits = sum >= 1u << 15;
  const std::int32_t shift = k.shift - (sixteen_bits ? 2 : 1);
  if (shift < 1) return m == 0;
  k.mantissa = static_cast<std::int32_t>(sixteen_bits ? (sum + 1) >> 1 : sum);
  k.shift = shift;
  return true;
}

}  // namespace arcspan
