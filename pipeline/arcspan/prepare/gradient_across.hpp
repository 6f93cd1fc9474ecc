// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Returns the gradient per column of a 16-bit attribute from its values at the top, middle and bottom vertex
/// of a TriangleFrame.
template <class Value, class Frame>
[[nodiscard]] ARCSPAN_INLINE constexpr Value gradient_across(const Frame& frame, std::int32_t top,
                                                             std::int32_t middle, std::int32_t bottom) {
  constexpr int kBits = kFractionBits<Value>;
  const std::int32_t fraction = frame.middle_fraction.raw() >> (Factor::kFraction - kBits);
  const std::int32_t along = round_shift(wrap_mul(bottom - top, fraction), kBits);
  const std::int32_t across = middle - (top + along);
  return gradient<Value>(frame.middle_left ? -across : across, frame.inverse_width, 16);
}

}  // namespace arcspan
