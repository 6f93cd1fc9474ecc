// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// An attribute linear on the screen, on its way down a left edge.
template <class Value>
struct BasicLinearEdge {
  Value at;    ///< on the edge, at the row's centre line
  Value step;  ///< per row
};

/// An attribute linear on the screen: its values along the left edge, and its gradient along a row. `lower`
/// takes the left edge's place at the middle row if the middle vertex is on the left.
template <class Value>
struct BasicLinearPlane {
  BasicLinearEdge<Value> left;
  BasicLinearEdge<Value> lower;
  Value dx;  ///< per pixel

  constexpr void next_row() { left.at += left.step; }
  constexpr void enter_lower(bool middle_left) {
    if (!middle_left) return;
    left.at = lower.at;
    left.step = lower.step;
  }
};

/// Of any 16-bit attribute, and of one whose values are at most 65280 apart.
using LinearPlane = BasicLinearPlane<Linear>;
using FullLinearPlane = BasicLinearPlane<FullLinear>;

/// The largest gradient: the whole 16-bit range in one pixel, or what fits of it. A steeper one only occurs
/// in triangles narrower than a pixel, whose spans have one pixel and do not step. What does not fit leaves
/// room for rounding the gradient to a multiple of 32 (`FineRgb`).
template <class Value>
inline constexpr std::int32_t kMaxGradient = static_cast<std::int32_t>((std::int64_t{1}
                                                                        << (16 + Value::kFraction)) -
                                                                       (Value::kFraction < 15 ? 0 : 32));

/// How many bits of a fraction a product with a difference of two values has room for.
template <class Value>
inline constexpr int kFractionBits = Value::kFraction < 15 ? 14 : 15;

/// value * fraction, |value| <= 2^29, fraction with 16 fraction bits in 0...1, rounded down; 32-bit
/// multiplies.
[[nodiscard]] constexpr Linear times_fraction(Linear value, std::uint32_t fraction) {
  return Linear::from_raw(scaled_down(value.raw(), fraction, 16));
}

/// difference / (distance) as a gradient per unit, saturated at kMaxGradient; `difference` is a 16-bit
/// attribute's, |difference| < 2^16; the distance is given by its reciprocal with `bits` fraction bits.
template <class Value>
[[nodiscard]] constexpr Value gradient(std::int32_t difference, const Reciprocal& inverse, int bits) {
  // 1/distance = mantissa * 2^(bits - exponent); the product with a 15-bit mantissa fits 32 bits.
  constexpr std::int32_t kMax = kMaxGradient<Value>;
  const std::int32_t product = wrap_mul(difference, static_cast<std::int32_t>(inverse.mantissa >> 1));
  const int shift = inverse.exponent - 1 - bits - Value::kFraction;
  if (shift >= 31) return Value{};
  if (shift >= 1) {
    const std::int32_t slope = ((product >> (shift - 1)) + 1) >> 1;  // rounded, without a shifted half
    if (slope > kMax || slope < -kMax) [[unlikely]] {
      return Value::from_raw(slope < 0 ? -kMax : kMax);
    }
    return Value::from_raw(slope);
  }
  const std::int32_t limit = shift < -28 ? 0 : kMax >> -shift;
  if (product > limit) return Value::from_raw(kMax);
  if (product < -limit) return Value::from_raw(-kMax);
  return Value::from_raw(wrap_shl(product, -shift < 31 ? -shift : 0));
}

/// difference * fraction, 0...1, in format `Value`.
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

/// Attribute `from` at the top of an edge and `to` at its bottom, 16 bits each.
template <class Value>
constexpr void make_linear_edge(const EdgeSetup& edge, std::int32_t from, std::int32_t to,
                                BasicLinearEdge<Value>& linear) {
  const std::int32_t difference = to - from;
  const std::int32_t part = part_of<Value>(difference, start_fraction(edge));
  linear.at = Value::from_raw(wrap_add(wrap_shl(from, Value::kFraction), part));
  linear.step = gradient<Value>(difference, edge.inverse, Subpixel::kFraction);
}

/// The attribute at a row's first pixel. Beyond the first column it goes in whole steps, so that cutting a
/// row changes nothing.
[[nodiscard]] ARCSPAN_INLINE constexpr Linear linear_at(const LinearPlane& plane, const RowStart& start) {
  const Linear first = plane.left.at + times_fraction(plane.dx, start.fraction);
  if (start.skipped == 0) [[likely]] {
    return first;
  }
  return first + Linear::from_raw(wrap_mul(plane.dx.raw(), start.skipped));
}

/// The same by one multiply for what lies within a pixel, with an error below 2: an 8-bit step has 256.
[[nodiscard]] ARCSPAN_INLINE constexpr FullLinear linear_at(const FullLinearPlane& plane,
                                                            const RowStart& start) {
  const std::int32_t inside = wrap_mul(plane.dx.raw() >> 16, static_cast<std::int32_t>(start.fraction));
  const std::int32_t skipped = wrap_mul(plane.dx.raw(), start.skipped);
  return plane.left.at + FullLinear::from_raw(wrap_add(inside, skipped));
}

}  // namespace arcspan
