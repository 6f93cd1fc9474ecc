// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// a * b in format `To`, rounded as multiply() does, by a 64-bit product: right for any two numbers, and
/// saturated where `To` does not hold the result. For what a program moves, such as a camera by a WorldLength
/// times a RotationEntry of its axis, which multiply() wraps; too slow for vertices.
template <class To, class A, class B>
[[nodiscard]] constexpr To multiply_wide(A a, B b) {
  using Rep = typename To::Rep;
  constexpr int kShift = A::kFraction + B::kFraction - To::kFraction;
  static_assert(kShift >= 0 && kShift < 62);
  constexpr std::int64_t kHalf = kShift == 0 ? 0 : (std::int64_t{1} << kShift) >> 1;
  const std::int64_t product = (std::int64_t{a.raw()} * b.raw() + kHalf) >> kShift;
  constexpr std::int64_t kMost = (std::int64_t{1} << (8 * sizeof(Rep) - 1)) - 1;
  const std::int64_t saturated = product > kMost ? kMost : product < -kMost - 1 ? -kMost - 1 : product;
  return To::from_raw(static_cast<Rep>(saturated));
}

}  // namespace arcspan
