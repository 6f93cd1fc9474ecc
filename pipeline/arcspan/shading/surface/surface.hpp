// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Scalars as surfaces over a triangle: planes, and quadratic surfaces
///
///     f = sum I_i l_i + sum_{i<j} b_ij l_i l_j,
///
/// where l are the barycentric coordinates, I the values at the vertices and b the *bends* of the edges.
/// Along an edge f depends on that edge alone, so that neighbouring triangles agree. Down the left edge and
/// along the rows f is stepped by differences, without a multiply.
///
/// Slopes are per SlopeUnit, a pixel or the width of a sliver.
namespace arcspan {

/// A scalar that is linear on the screen.
struct PlaneScalar {
  /// Along the left edge.
  struct Edge {
    Cosine at;    ///< on the left edge, at the row's centre line
    Cosine step;  ///< change per row
  };
  Edge left;
  Edge lower;          ///< replaces `left` at the middle row if the middle vertex is on the left
  std::int32_t slope;  ///< change per pixel, 29 fraction bits: |slope| <= 2

  ARCSPAN_INLINE constexpr void next_row() { left.at += left.step; }
  constexpr void enter_lower() {
    left.at = lower.at;
    left.step = lower.step;
  }
};

/// A scalar with bends.
struct BentScalar {
  /// Along the left edge.
  struct Edge {
    Cosine at;                 ///< on the left edge, at the row's centre line
    Cosine step;               ///< difference to the next row
    Cosine second_difference;  ///< change of `step` per row
    std::int32_t slope;        ///< derivative along x on the edge, per pixel, as SurfaceFormat says
    std::int32_t slope_step;   ///< change of `slope` per row
  };
  Edge left;
  Edge lower;                      ///< as in PlaneScalar
  std::int32_t second_difference;  ///< per pixel along a row

  ARCSPAN_INLINE constexpr void next_row() {
    left.at += left.step;
    left.step += left.second_difference;
    left.slope = wrap_add(left.slope, left.slope_step);
  }
  /// Assigns member by member, because a call of memcpy costs more on cores with few registers.
  constexpr void enter_lower() {
    left.at = lower.at;
    left.step = lower.step;
    left.second_difference = lower.second_difference;
    left.slope = lower.slope;
    left.slope_step = lower.slope_step;
  }
};

/// The formats of a BentScalar, chosen so that differences of chords of up to 4 fit.
struct SurfaceFormat {
  int dropped;        ///< values and bends are given with 30 - dropped fraction bits
  int slope_dropped;  ///< what changes along x has 30 - slope_dropped fraction bits
};

/// A value or a bend at the vertices or edges of a triangle.
struct CornerValues {
  std::int32_t top;
  std::int32_t middle;
  std::int32_t bottom;
};
/// The bends of the three edges, 30 fraction bits.
struct EdgeBends {
  std::int32_t top_middle;
  std::int32_t top_bottom;
  std::int32_t middle_bottom;
};

/// The bend of an edge divided by the mean of its two values, 18 fraction bits: 4 (1 / cos(psi/2) - 1), which
/// makes a quadratic surface go through the middle of the arc. `chord` is the squared chord s of the edge, 28
/// fraction bits, at most 0.33 (33 degrees), by the series s/2 + 3/32 s^2 + 5/256 s^3.
[[nodiscard]] constexpr std::int32_t sagitta_factor(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;                         // 15 fraction bits
  const std::uint32_t inner = 3072u + ((s * 5u + 128u) >> 8);  // 3/32 + 5/256 s, 15 fraction bits
  return static_cast<std::int32_t>(((chord + 1024) >> 11) + (((s * s) >> 12) * inner >> 15));
}

/// Returns the bend of an edge between the values p and q, 30 fraction bits.
[[nodiscard]] constexpr std::int32_t sagitta(Cosine p, Cosine q, std::int32_t factor) {
  return round_shift(wrap_mul(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15, factor), 3);
}

namespace detail {

/// Returns v * f, rounded down, for f in 0...1. It keeps all bits by two products, because an error in a part
/// of a surface acts as an error of the normal's length, to which highlights are most sensitive.
[[nodiscard]] constexpr std::int32_t part(std::int32_t v, Factor f) {
  return scaled_down(v, static_cast<std::uint32_t>(f.raw()), Factor::kFraction);
}

/// The inverse of a length of at least 1 in pixels or rows: fraction * 2^-down.
struct InverseLength {
  Factor fraction;
  int down;
};

/// `inverse` is the reciprocal of the length with `bits` fraction bits.
[[nodiscard]] constexpr InverseLength inverse_length(const Reciprocal& inverse, int bits) {
  return {Factor::from_raw(static_cast<std::int32_t>(inverse.mantissa >> 1)), inverse.exponent - bits - 16};
}

[[nodiscard]] constexpr std::int32_t over_length(std::int32_t v, const InverseLength& length) {
  return part(v, length.fraction) >> length.down;
}

/// Returns v / (length of `one` * length of `other`) with `up` more fraction bits than v, rounded to nearest.
/// It makes differences of differences, whose rounding error is summed twice.
[[nodiscard]] constexpr std::int32_t over_lengths(std::int32_t v, const InverseLength& one,
                                                  const InverseLength& other, int up) {
  const std::int32_t product = part(part(v, one.fraction), other.fraction);
  const int down = one.down + other.down - up;
  if (down <= 0) return wrap_shl(product, -down);
  return round_shift(product, down < 31 ? down : 31);
}

/// Sets up a plane along an edge, from its upper end `from`; `to_bottom` is half the change to its lower end.
constexpr void make_linear_edge(const EdgeSetup& edge, Cosine from, std::int32_t to_bottom,
                                PlaneScalar::Edge& e) {
  e.at = from + Cosine::from_raw(wrap_shl(part(to_bottom, edge.start), 1));
  e.step = Cosine{};
  if (edge.dy < 1 << Subpixel::kFraction) return;  // the edge has one row
  const InverseLength row = inverse_length(edge.inverse, Subpixel::kFraction);
  e.step = Cosine::from_raw(wrap_shl(over_length(to_bottom, row), 1));
}

/// A value at one end of an edge, and its derivative along x per width of the triangle.
struct SurfaceEnd {
  std::int32_t value;
  std::int32_t slope;
};

/// Sets up a quadratic surface along an edge with the given bend; `pixel` is the inverse SlopeUnit.
constexpr void make_quadratic_edge(const EdgeSetup& edge, const InverseLength& pixel, const SurfaceEnd& from,
                                   const SurfaceEnd& to, std::int32_t bend, const SurfaceFormat& format,
                                   BentScalar::Edge& e) {
  // f(t) = from + t (to - from + bend) - t^2 bend, t = 0...1 along the edge
  const Factor t = edge.start;
  const int slope_up = format.dropped - format.slope_dropped;
  const std::int32_t slope_at_top = wrap_add(wrap_sub(to.value, from.value), bend);
  const std::int32_t bend_by_t = part(bend, t);
  const std::int32_t slope_change = wrap_sub(to.slope, from.slope);
  e.at = Cosine::from_raw(
      wrap_shl(wrap_add(from.value, part(wrap_sub(slope_at_top, bend_by_t), t)), format.dropped));
  e.slope = wrap_shl(over_length(wrap_add(from.slope, part(slope_change, t)), pixel), slope_up);
  e.step = e.second_difference = Cosine{};
  e.slope_step = 0;
  if (edge.dy < 1 << Subpixel::kFraction) return;  // the edge has one row
  const InverseLength row = inverse_length(edge.inverse, Subpixel::kFraction);
  e.second_difference = -Cosine::from_raw(over_lengths(wrap_shl(bend, 1), row, row, format.dropped));
  // Not half of the second difference, which may exceed the range of -2...2: only its effect wraps correctly.
  const std::int32_t at_t = wrap_sub(wrap_sub(slope_at_top, wrap_shl(bend_by_t, 1)), over_length(bend, row));
  e.step = Cosine::from_raw(wrap_shl(over_length(at_t, row), format.dropped));
  e.slope_step = over_lengths(slope_change, row, pixel, slope_up);
}

}  // namespace detail

/// Makes a plane from its values at the vertices, of any scalars of -1...1. Halves are taken where two of
/// them are subtracted, so that the difference fits.
template <class Method>
ARCSPAN_OUTLINE constexpr void make_linear_scalar(const TriangleFrame<Method>& frame, Cosine top,
                                                  Cosine middle, Cosine bottom, PlaneScalar& scalar) {
  const std::int32_t to_middle = wrap_sub(middle.raw() >> 1, top.raw() >> 1);
  const std::int32_t to_bottom = wrap_sub(bottom.raw() >> 1, top.raw() >> 1);
  const std::int32_t across = wrap_sub(to_middle, detail::part(to_bottom, frame.middle_fraction));
  scalar.slope = detail::over_length(frame.middle_left ? -across : across,
                                     detail::inverse_length(frame.inverse_unit, 16));
  if (!frame.middle_left) {
    detail::make_linear_edge(frame.long_edge, top, to_bottom, scalar.left);
    return;
  }
  if (frame.has_upper) detail::make_linear_edge(frame.upper_edge, top, to_middle, scalar.left);
  if (frame.has_lower)
    detail::make_linear_edge(frame.lower_edge, middle, wrap_sub(to_bottom, to_middle), scalar.lower);
}

/// Makes a quadratic surface. Let t be the fraction of the triangle's height, m that of the middle vertex,
/// and q the distance from the long edge as a fraction of the widest row. Then the barycentric coordinates
/// are l_middle = q and l_bottom = t - m q, and f = F(t) + q G(t) + q^2 H.
template <class Method>
ARCSPAN_OUTLINE constexpr void make_quadratic_scalar(const TriangleFrame<Method>& frame,
                                                     const CornerValues& at, const EdgeBends& bends,
                                                     const SurfaceFormat& format, BentScalar& scalar) {
  using detail::part;
  const Factor m = frame.middle_fraction;
  const std::int32_t long_m = part(bends.top_bottom, m);
  const std::int32_t long_rest = wrap_sub(bends.top_bottom, long_m);
  // How far the middle vertex is above the long edge's chord.
  const std::int32_t across = wrap_sub(wrap_sub(at.middle, at.top), part(wrap_sub(at.bottom, at.top), m));
  const std::int32_t h = wrap_sub(
      part(wrap_add(wrap_sub(long_rest, bends.middle_bottom), bends.top_middle), m), bends.top_middle);
  // G at the three vertices.
  std::int32_t g_top = wrap_sub(wrap_add(across, bends.top_middle), long_m);
  std::int32_t g_bottom = wrap_sub(wrap_add(across, bends.middle_bottom), long_rest);
  std::int32_t g_middle = wrap_add(wrap_add(g_top, part(wrap_sub(g_bottom, g_top), m)), wrap_shl(h, 1));
  const detail::InverseLength pixel = detail::inverse_length(frame.inverse_unit, 16);
  scalar.second_difference =
      detail::over_lengths(wrap_shl(h, 1), pixel, pixel, format.dropped - format.slope_dropped);
  if (!frame.middle_left) {
    detail::make_quadratic_edge(frame.long_edge, pixel, {at.top, g_top}, {at.bottom, g_bottom},
                                bends.top_bottom, format, scalar.left);
    return;
  }
  // q runs from right to left.
  g_top = -g_top;
  g_middle = -g_middle;
  g_bottom = -g_bottom;
  if (frame.has_upper) {
    detail::make_quadratic_edge(frame.upper_edge, pixel, {at.top, g_top}, {at.middle, g_middle},
                                bends.top_middle, format, scalar.left);
  }
  if (frame.has_lower) {
    detail::make_quadratic_edge(frame.lower_edge, pixel, {at.middle, g_middle}, {at.bottom, g_bottom},
                                bends.middle_bottom, format, scalar.lower);
  }
}

}  // namespace arcspan
