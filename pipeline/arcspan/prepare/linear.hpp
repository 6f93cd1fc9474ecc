// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/gradient.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

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
  Value dx;  ///< per pixel

  ARCSPAN_INLINE constexpr void next_row() { left.at += left.step; }
  /// Steps `rows` rows at once; the result is that of `rows` calls of next_row().
  constexpr void skip_rows(std::int32_t rows) { left.at += Value::from_raw(wrap_mul(left.step.raw(), rows)); }
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

/// Sets up an attribute along an edge: `from` at its top, `to` at its bottom, 16 bits each.
template <class Value>
ARCSPAN_INLINE_AT_OS constexpr void make_linear_edge(const EdgeSetup& edge, std::int32_t from,
                                                     std::int32_t to, BasicLinearEdge<Value>& linear) {
  const std::int32_t difference = to - from;
  const std::int32_t part = part_of<Value>(difference, edge.start);
  linear.at = Value::from_raw(wrap_add(wrap_shl(from, Value::kFraction), part));
  linear.step = gradient<Value>(difference, edge.inverse, Subpixel::kFraction);
}

/// Returns the attribute at a row's first pixel. Every skipped column adds exactly one gradient, so that
/// starting a row later does not change its pixels.
[[nodiscard]] ARCSPAN_INLINE constexpr Linear linear_at(const LinearPlane& plane, const RowStart& start) {
  const Linear first =
      Linear::from_raw(plus_scaled_down(plane.left.at.raw(), plane.dx.raw(), start.fraction));
  if (start.skipped == 0) [[likely]] {
    return first;
  }
  return first + Linear::from_raw(wrap_mul(plane.dx.raw(), start.skipped));
}

/// Returns the attribute at a row's first pixel. The fraction of a pixel takes one multiply, whose error is
/// below 2; Gouraud's colours have 256 per 8-bit step.
[[nodiscard]] ARCSPAN_INLINE constexpr FullLinear linear_at(const FullLinearPlane& plane,
                                                            const RowStart& start) {
  const std::int32_t inside = wrap_mul(plane.dx.raw() >> 16, static_cast<std::int32_t>(start.fraction));
  const std::int32_t skipped = wrap_mul(plane.dx.raw(), start.skipped);
  return plane.left.at + FullLinear::from_raw(wrap_add(inside, skipped));
}

}  // namespace arcspan
