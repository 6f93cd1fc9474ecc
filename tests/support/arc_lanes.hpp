// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/shading/arc/recurrence.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace arcspan {

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
