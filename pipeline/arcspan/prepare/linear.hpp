// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/edge.hpp>

#include <cstdint>

namespace arcspan {

/// An attribute linear on the screen, on its way down a left edge.
struct LinearEdge {
  Linear at;    ///< on the edge, at the row's centre line
  Linear step;  ///< per row
};

/// An attribute linear on the screen: its values along the left edge, and its gradient along a row. `lower`
/// takes the left edge's place at the middle row if the middle vertex is on the left.
struct LinearPlane {
  LinearEdge left;
  LinearEdge lower;
  Linear dx;  ///< per pixel

  constexpr void next_row() { left.at += left.step; }
  constexpr void enter_lower(bool middle_left) {
    if (!middle_left) return;
    left.at = lower.at;
    left.step = lower.step;
  }
};

/// The largest gradient: the whole 16-bit range in one pixel. A steeper one only occurs in triangles narrower
/// than a pixel, whose spans have one pixel and do not step.
inline constexpr std::int32_t kMaxGradient = std::int32_t{1} << (16 + Linear::kFraction);

/// value * fraction, |value| <= 2^29, fraction with 16 fraction bits in 0...1, rounded down; 32-bit
/// multiplies.
[[nodiscard]] constexpr Linear times_fraction(Linear value, std::uint32_t fraction) {
  const std::int32_t high = wrap_mul(value.raw() >> 16, static_cast<std::int32_t>(fraction));
  const std::uint32_t low = (static_cast<std::uint32_t>(value.raw()) & 0xFFFFu) * fraction;
  return Linear::from_raw(wrap_add(high, static_cast<std::int32_t>(low >> 16)));
}

/// difference / (distance) as a gradient per unit, saturated at kMaxGradient; `difference` is a 16-bit
/// attribute's, |difference| < 2^16; the distance is given by its reciprocal with `bits` fraction bits.
[[nodiscard]] constexpr Linear gradient(std::int32_t difference, const Reciprocal& inverse, int bits) {
  // 1/distance = mantissa * 2^(bits - exponent); the product with a 15-bit mantissa fits 32 bits.
  const std::int32_t product = wrap_mul(difference, static_cast<std::int32_t>(inverse.mantissa >> 1));
  const int shift = inverse.exponent - 1 - bits - Linear::kFraction;
  if (shift >= 31) return Linear{};
  if (shift >= 1) {
    const std::int32_t slope = round_shift(product, shift);
    return Linear::from_raw(slope > kMaxGradient    ? kMaxGradient
                            : slope < -kMaxGradient ? -kMaxGradient
                                                    : slope);
  }
  const std::int32_t limit = shift < -28 ? 0 : kMaxGradient >> -shift;
  if (product > limit) return Linear::from_raw(kMaxGradient);
  if (product < -limit) return Linear::from_raw(-kMaxGradient);
  return Linear::from_raw(wrap_shl(product, -shift < 31 ? -shift : 0));
}

/// Attribute `from` at the top of an edge and `to` at its bottom, 16 bits each.
[[nodiscard]] constexpr LinearEdge make_linear_edge(const EdgeSpan& edge, std::int32_t from,
                                                    std::int32_t to) {
  const std::int32_t difference = to - from;
  const std::int32_t product = wrap_mul(difference, start_fraction(edge).raw() >> 1);  // 14 fraction bits
  LinearEdge linear;
  linear.at = Linear::from_raw(wrap_add(wrap_shl(from, Linear::kFraction), round_shift(product, 2)));
  linear.step = gradient(difference, edge.inverse, Subpixel::kFraction);
  return linear;
}

}  // namespace arcspan
