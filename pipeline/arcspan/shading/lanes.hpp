// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/recurrence.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Turns k = 2 - 2 cos(phi) into that of twice the step, k(2 phi) = k (4 - k). `k` must have no fine bits.
/// False, with k as it was, if the doubled one is 1/4 or more, which ArcStep cannot hold: 28.9 degrees.
[[nodiscard]] constexpr bool double_stride(ArcStep& k) {
  // k = m 2^-(16 + s), so k (4 - k) = 2 (2 m - m^2 2^-(17 + s)) 2^-(16 + s).
  const auto m = static_cast<std::uint32_t>(k.mantissa);
  const std::int32_t down = 17 + k.shift;
  const std::uint32_t bend = down > 31 ? 0u : (m * m + (1u << (down - 1))) >> down;
  const std::uint32_t sum = 2 * m - bend;
  const bool sixteen_bits = sum >= 1u << 15;
  const std::int32_t shift = k.shift - (sixteen_bits ? 2 : 1);
  if (shift < 1) return m == 0;
  k.mantissa = static_cast<std::int32_t>(sixteen_bits ? (sum + 1) >> 1 : sum);
  k.shift = shift;
  return true;
}

/// k of `Count` steps at once; false if it cannot be held.
template <std::size_t Count>
[[nodiscard]] constexpr bool make_stride(ArcStep& k) {
  static_assert(std::has_single_bit(Count));
  const ArcStep single = k;
  for (std::size_t stride = 1; stride < Count; stride *= 2) {
    if (double_stride(k)) continue;
    k = single;
    return false;
  }
  return true;
}

/// `Count` neighbouring pixels of one scalar, all stepped by `Count` pixels at once. The recurrence holds for
/// any stride, N(t+j) = 2 cos(j phi) N(t) - N(t-j) (S0 eq. 9 to 11, of which 10 and 11 are printed wrong:
/// docs/papers.md), so every lane runs by itself and with the same k: vector units, or hardware side by side.
template <std::size_t Count>
struct ArcLanes {
  std::array<ArcScalar, Count> lanes;

  /// From the first pixel's state and the single step's k, by 2 Count - 1 single steps. Exact for them: the
  /// first 2 Count values are the single step's, bit for bit.
  constexpr void start(ArcScalar first, const ArcStep& single) {
    for (ArcScalar& lane : lanes) {
      lane.x = first.x;
      first.step(single.mantissa, single.shift);
    }
    for (ArcScalar& lane : lanes) {
      lane.d = first.x - lane.x;
      first.step(single.mantissa, single.shift);
    }
  }

  /// `stride` is the single step's k after make_stride<Count>().
  constexpr void step(const ArcStep& stride) {
    unrolled<Count>([&](auto i) { lanes[i].step(stride.mantissa, stride.shift); });
  }
};

}  // namespace arcspan
