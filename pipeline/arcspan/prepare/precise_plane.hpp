// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Makes planes as make_linear_plane() does, but of values with all 28 bits of a Linear and with errors of
/// about 2^-26 of their range instead of 2^-15: for attributes whose quotients are taken.
template <class Frame>
class PrecisePlanes {
 public:
  constexpr explicit PrecisePlanes(const Frame& frame)
      : frame_(frame),
        inverse_unit_(wide_reciprocal(frame.width < kPixel ? kPixel : frame.width)),
        inverse_long_(wide_reciprocal(static_cast<std::uint32_t>(frame.long_edge.dy))),
        middle_fraction_(fraction(frame.middle->position.y - frame.top->position.y, inverse_long_)) {}

  /// Sets up the plane through raw values of Linear, below 2^28.
  constexpr void make(std::int32_t top, std::int32_t middle, std::int32_t bottom, LinearPlane& plane) const {
    const std::int32_t across = middle - (top + part(bottom - top, middle_fraction_));
    plane.dx = Linear::from_raw(quotient(frame_.middle_left ? -across : across, inverse_unit_, 16));
    plane.left = {};
    plane.lower = {};
    if (!frame_.middle_left) {
      make_edge(frame_.long_edge, inverse_long_, top, bottom, plane.left);
      return;
    }
    if (frame_.has_upper)
      make_edge(frame_.upper_edge, inverse_of(frame_.upper_edge), top, middle, plane.left);
    if (frame_.has_lower)
      make_edge(frame_.lower_edge, inverse_of(frame_.lower_edge), middle, bottom, plane.lower);
  }

 private:
  static constexpr std::uint32_t kPixel = std::uint32_t{1} << 16;

  [[nodiscard]] static constexpr WideReciprocal inverse_of(const EdgeSetup& edge) {
    return wide_reciprocal(static_cast<std::uint32_t>(edge.dy));
  }
  /// The mantissa as a positive int32_t.
  [[nodiscard]] static constexpr std::int32_t mantissa(const WideReciprocal& inverse) {
    return static_cast<std::int32_t>(inverse.mantissa - (inverse.mantissa >> 31));
  }
  /// value / distance * 2^bits, |value| < 2^29.
  [[nodiscard]] static constexpr std::int32_t quotient(std::int32_t value, const WideReciprocal& inverse,
                                                       int bits) {
    const std::int32_t product = multiply_high(wrap_shl(value, 2), mantissa(inverse));  // times 2^-30
    const int shift = inverse.exponent - bits - 30;
    return shift >= 0 ? (shift > 31 ? 0 : product >> shift) : wrap_shl(product, -shift);
  }
  /// offset / height with 30 fraction bits; 0 <= offset <= height < 2^15.
  [[nodiscard]] static constexpr std::int32_t fraction(std::int32_t offset, const WideReciprocal& inverse) {
    return quotient(offset << 14, inverse, 16);
  }
  [[nodiscard]] static constexpr std::int32_t part(std::int32_t difference, std::int32_t fraction) {
    return multiply_high(wrap_shl(difference, 2), fraction);
  }
  static constexpr void make_edge(const EdgeSetup& edge, const WideReciprocal& inverse, std::int32_t from,
                                  std::int32_t to, BasicLinearEdge<Linear>& linear) {
    linear.at = Linear::from_raw(from + part(to - from, fraction(edge.offset, inverse)));
    linear.step = Linear::from_raw(quotient(to - from, inverse, Subpixel::kFraction));
  }

  const Frame& frame_;
  WideReciprocal inverse_unit_;
  WideReciprocal inverse_long_;
  std::int32_t middle_fraction_;  ///< 30 fraction bits
};

}  // namespace arcspan
