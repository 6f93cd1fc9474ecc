// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Attributes that are linear on the screen: their gradients, along an edge and along a row.
namespace arcspan {

/// Raw value of the largest gradient, 2^16 per unit or row. A steeper one only occurs in edges lower than a
/// row, which do not step. For FullLinear it is 1 less, which fits 32 bits.
template <class Value>
inline constexpr std::int32_t kMaxGradient =
    static_cast<std::int32_t>((std::int64_t{1} << (16 + Value::kFraction)) - (Value::kFraction < 15 ? 0 : 1));

namespace detail {

/// Returns product / 2^shift, rounded and saturated at +-most; `shift` is -16...30.
ARCSPAN_OUTLINE ARCSPAN_COLD [[nodiscard]] constexpr std::int32_t steep_gradient(std::int32_t product,
                                                                                 int shift,
                                                                                 std::int32_t most) {
  const std::int32_t quotient = shift < 1 ? product : ((product >> (shift - 1)) + 1) >> 1;
  const std::int32_t limit = shift < 0 ? most >> -shift : most;
  if (quotient > limit) return most;
  if (quotient < -limit) return -most;
  return shift < 0 ? wrap_shl(quotient, -shift) : quotient;
}

}  // namespace detail

/// Returns difference / distance, a gradient per unit or row, saturated at +-kMaxGradient. `difference` is
/// that of two 16-bit attributes, |difference| < 2^16; `inverse` is the reciprocal of the distance, which has
/// `bits` fraction bits.
template <class Value>
[[nodiscard]] constexpr Value gradient(std::int32_t difference, const Reciprocal& inverse, int bits) {
  // 1/distance = mantissa * 2^(bits - exponent); the product with a 15-bit mantissa fits 32 bits. From the
  // shift kFlat on, which a distance above 1 has, no quotient exceeds the largest gradient.
  constexpr int kFlat = Value::kFraction < 15 ? 15 - Value::kFraction : 1;
  const std::int32_t product = wrap_mul(difference, static_cast<std::int32_t>(inverse.mantissa >> 1));
  const int shift = inverse.exponent - 1 - bits - Value::kFraction;
  if (shift < kFlat) [[unlikely]] {
    return Value::from_raw(detail::steep_gradient(product, shift, kMaxGradient<Value>));
  }
  return Value::from_raw(((product >> (shift - 1)) + 1) >> 1);  // rounds without overflow
}

/// An attribute that is linear on the screen, along a left edge.
template <class Value>
struct BasicLinearEdge {
  Value at;    ///< value where the edge crosses the row's centre line
  Value step;  ///< per row
};

/// An attribute that is linear on the screen: its values along the left edge and its gradient along the rows.
/// At the middle row `lower` replaces `left` if the middle vertex is on the left.
template <class Value>
struct BasicLinearPlane {
  BasicLinearEdge<Value> left;
  BasicLinearEdge<Value> lower;
  Value dx;  ///< per SlopeUnit

  ARCSPAN_INLINE constexpr void next_row() { left.at += left.step; }
  constexpr void enter_lower(bool middle_left) {
    if (!middle_left) return;
    left.at = lower.at;
    left.step = lower.step;
  }
};

/// LinearPlane is for any 16-bit attribute, FullLinearPlane for values that differ by at most 65280.
using LinearPlane = BasicLinearPlane<Linear>;
using FullLinearPlane = BasicLinearPlane<FullLinear>;

/// The fraction bits that a factor may have so that its product with a difference of two values fits 32 bits.
template <class Value>
inline constexpr int kFractionBits = Value::kFraction < 15 ? 14 : 15;

/// Returns difference * fraction in the format of `Value`; `fraction` is in 0...1.
template <class Value>
[[nodiscard]] constexpr std::int32_t part_of(std::int32_t difference, Factor fraction) {
  constexpr int kBits = kFractionBits<Value>;
  const std::int32_t product = wrap_mul(difference, fraction.raw() >> (Factor::kFraction - kBits));
  if constexpr (kBits == Value::kFraction) {
    return product;
  } else {
    return round_shift(product, kBits - Value::kFraction);
  }
}

/// Returns the gradient per SlopeUnit of a 16-bit attribute from its values at the top, middle and bottom
/// vertex of a TriangleFrame.
template <class Value, class Frame>
[[nodiscard]] ARCSPAN_INLINE constexpr Value gradient_across(const Frame& frame, std::int32_t top,
                                                             std::int32_t middle, std::int32_t bottom) {
  constexpr int kBits = kFractionBits<Value>;
  const std::int32_t fraction = frame.middle_fraction.raw() >> (Factor::kFraction - kBits);
  const std::int32_t along = round_shift(wrap_mul(bottom - top, fraction), kBits);
  const std::int32_t across = middle - (top + along);
  return gradient<Value>(frame.middle_left ? -across : across, frame.inverse_unit, 16);
}

/// Sets up an attribute along an edge: `from` at its top, `to` at its bottom, 16 bits each.
template <class Value>
ARCSPAN_INLINE constexpr void make_linear_edge(const EdgeSetup& edge, std::int32_t from, std::int32_t to,
                                               BasicLinearEdge<Value>& linear) {
  const std::int32_t difference = to - from;
  const std::int32_t part = part_of<Value>(difference, edge.start);
  linear.at = Value::from_raw(wrap_add(wrap_shl(from, Value::kFraction), part));
  linear.step = gradient<Value>(difference, edge.inverse, Subpixel::kFraction);
}

/// Returns the attribute at a row's first pixel. Every skipped column adds exactly one gradient, so that
/// starting a row later does not change its pixels.
[[nodiscard]] ARCSPAN_INLINE constexpr Linear linear_at(const LinearPlane& plane, const RowStart& start) {
  const Linear first =
      Linear::from_raw(plus_scaled_down(plane.left.at.raw(), plane.dx.raw(), start.distance));
  if (start.skipped == 0) [[likely]] {
    return first;
  }
  return first + Linear::from_raw(wrap_mul(plane.dx.raw(), start.skipped));
}

/// Returns the attribute at a row's first pixel. The fraction of a pixel takes one multiply, whose error is
/// below 2; Gouraud's colours have 256 per 8-bit step.
[[nodiscard]] ARCSPAN_INLINE constexpr FullLinear linear_at(const FullLinearPlane& plane,
                                                            const RowStart& start) {
  const std::int32_t inside = wrap_mul(plane.dx.raw() >> 16, static_cast<std::int32_t>(start.distance));
  const std::int32_t skipped = wrap_mul(plane.dx.raw(), start.skipped);
  return plane.left.at + FullLinear::from_raw(wrap_add(inside, skipped));
}

}  // namespace arcspan
