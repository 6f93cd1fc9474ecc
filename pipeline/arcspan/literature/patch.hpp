// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/inverse_width.hpp>
#include <arcspan/literature/parabola.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/row_start.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// A patch replaces the arcs of a triangle whose normals are close together. Each scalar is the
/// quadratic surface through its values at the three vertices and at the middles of the three arcs:
///
///     f = sum I_i l_i + sum b_ij l_i l_j,     b_ij = 2 (I_i + I_j) (1 / cos(psi_ij / 2) - 1),
///
/// where l are the barycentric coordinates. b_ij is the *quadruple sagitta* of an edge: four times the height
/// of the arc above its chord at the middle, b = 4 (f(1/2) - (I_i + I_j) / 2). For a scalar that is linear in
/// the normal, S0 eq. 2 gives f(1/2) = (I_i + I_j) / (2 cos(psi_ij / 2)), hence the formula.
namespace arcspan::literature {

/// Returns v * f, rounded down, for f in 0...2, with all 30 fraction bits.
[[nodiscard]] constexpr Cosine part(Cosine v, Factor f) {
  return Cosine::from_raw(scaled_down(v.raw(), static_cast<std::uint32_t>(f.raw()), Factor::kFraction));
}

/// The inverse of a length in pixels or rows: fraction * 2^-down.
struct InverseLength {
  Factor fraction;
  int down;

  /// Returns the inverse of a length of at least 1/2, given as the reciprocal of the length with `bits`
  /// fraction bits.
  [[nodiscard]] static constexpr InverseLength of(const Reciprocal& inverse, int bits) {
    const int down = inverse.exponent - bits - 16;
    const std::uint32_t fraction = inverse.mantissa >> 1;
    if (down >= 0) return {Factor::from_raw(static_cast<std::int32_t>(fraction)), down};
    return {Factor::from_raw(static_cast<std::int32_t>(fraction << -down)), 0};
  }
  /// Returns v / length, rounded down.
  [[nodiscard]] constexpr Cosine times(Cosine v) const {
    return Cosine::from_raw(part(v, fraction).raw() >> down);
  }
  /// Returns v / (length * length of `other`), rounded to nearest. It makes differences of differences, whose
  /// rounding error is summed twice.
  [[nodiscard]] constexpr Cosine times(Cosine v, const InverseLength& other) const {
    const Cosine product = part(part(v, fraction), other.fraction);
    const int both = down + other.down;  // at most 14 in a triangle that fits a patch
    const std::int32_t half = (std::int32_t{1} << both) >> 1;
    return Cosine::from_raw(wrap_add(product.raw(), half) >> both);
  }
};

/// A scalar along a left edge, at the current row.
struct PatchEdge {
  Cosine at;                 ///< value on the edge, at the row's centre line
  Cosine step;               ///< difference to the next row
  Cosine second_difference;  ///< change of `step` per row
  Cosine slope;              ///< derivative along x on the edge, per pixel
  Cosine slope_step;         ///< change of `slope` per row

  constexpr void advance() {
    at += step;
    step += second_difference;
    slope += slope_step;
  }
};

/// A scalar over a triangle. At the middle row `lower` replaces `left` if the middle vertex is on the left.
struct PatchScalar {
  PatchEdge left;
  Cosine second_difference;  ///< per pixel along a row; the same for all rows
  PatchEdge lower;

  /// Returns the scalar at a row's first column. `p` is the distance in pixels from the left edge to that
  /// column: 16 fraction bits, 0 or more and below 1.
  [[nodiscard]] constexpr Parabola at(std::uint32_t p) const {
    // With b the second difference: f(p) = at + p slope + p^2 b / 2,  f(p + 1) - f(p) = slope + p b + b / 2.
    const std::int32_t b = second_difference.raw();
    const Cosine slope_change = Cosine::from_raw(wrap_mul(b >> 8, static_cast<std::int32_t>(p >> 8)));
    const Cosine mean = left.slope + Cosine::from_raw(slope_change.raw() >> 1);
    const Cosine inside = Cosine::from_raw(wrap_mul(mean.raw() >> 13, static_cast<std::int32_t>(p >> 3)));
    return {left.at + inside, left.slope + slope_change + Cosine::from_raw(b >> 1), second_difference};
  }
};

/// The patch of a triangle: `Count` scalars.
template <std::size_t Count>
using Patch = std::array<PatchScalar, Count>;

/// The quadruple sagitta of an edge divided by the mean of its two values: 4 (1 / cos(psi/2) - 1).
using SagittaFactor = Fixed<std::int32_t, 18>;

/// Returns the factor of an edge with the squared chord s = `chord` (28 fraction bits) by the series
/// s/2 + 3/32 s^2 + 5/256 s^3. s is at most 0.33 (33 degrees), where the factor is below 0.18.
[[nodiscard]] constexpr SagittaFactor sagitta_factor(std::uint32_t chord) {
  const std::uint32_t s = chord >> 13;                         // 15 fraction bits
  const std::uint32_t inner = 3072u + ((s * 5u + 128u) >> 8);  // 3/32 + 5/256 s, 15 fraction bits
  return SagittaFactor::from_raw(
      static_cast<std::int32_t>(((chord + 1024) >> 11) + (((s * s) >> 12) * inner >> 15)));
}

/// Returns the quadruple sagitta of an edge with the squared chord `chord` between the values p and q.
[[nodiscard]] constexpr Cosine sagitta4_between(Cosine p, Cosine q, std::uint32_t chord) {
  const Factor mean = Factor::from_raw(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15);
  return multiply<Cosine>(mean, sagitta_factor(chord));
}

/// The values of a scalar at the vertices.
struct PatchValues {
  Cosine top;
  Cosine middle;
  Cosine bottom;
};

/// A scalar at one end of an edge: its value, and its derivative along x per length of the widest row.
struct PatchEnd {
  Cosine value;
  Cosine slope;
};

/// Returns a scalar along an edge at the edge's first row. `from` is its upper end, `to` its lower end,
/// `sagitta4` its quadruple sagitta, and `pixel` the inverse width of the widest row in pixels.
[[nodiscard]] constexpr PatchEdge make_patch_edge(const EdgeSetup& edge, const InverseLength& pixel,
                                                  const PatchEnd& from, const PatchEnd& to, Cosine sagitta4) {
  // f(t) = from + t (to - from + sagitta4) - t^2 sagitta4, t = 0...1 along the edge.
  const Cosine slope_at_top = to.value - from.value + sagitta4;
  const Cosine sagitta4_by_t = part(sagitta4, edge.start);
  const Cosine slope_difference = to.slope - from.slope;
  PatchEdge e{};
  e.at = from.value + part(slope_at_top - sagitta4_by_t, edge.start);
  e.slope = pixel.times(from.slope + part(slope_difference, edge.start));
  if (edge.dy < 1 << Subpixel::kFraction) return e;  // the edge has one row
  const InverseLength row = InverseLength::of(edge.inverse, Subpixel::kFraction);
  e.second_difference = -row.times(sagitta4 + sagitta4, row);
  e.step = row.times(slope_at_top - sagitta4_by_t - sagitta4_by_t) +
           Cosine::from_raw(e.second_difference.raw() >> 1);
  e.slope_step = row.times(slope_difference, pixel);
  return e;
}

/// Makes a scalar of a patch from its values at the vertices. Let t be the fraction of the triangle's height,
/// m that of the middle vertex, and q the distance from the long edge as a fraction of the widest row. Then
/// the barycentric coordinates are l_middle = q and l_bottom = t - m q, and f = F(t) + q G(t) + q^2 H.
template <class Frame>
ARCSPAN_OUTLINE constexpr void make_patch_scalar(const Frame& frame, const PatchValues& at,
                                                 PatchScalar& scalar) {
  const Cosine top_middle = sagitta4_between(at.top, at.middle, frame.chords.top_middle);
  const Cosine top_bottom = sagitta4_between(at.top, at.bottom, frame.chords.top_bottom);
  const Cosine middle_bottom = sagitta4_between(at.middle, at.bottom, frame.chords.middle_bottom);
  const Factor m = frame.middle_fraction;
  const Cosine long_m = part(top_bottom, m);
  const Cosine long_rest = top_bottom - long_m;
  // How far the middle vertex is above the long edge's chord.
  const Cosine across = at.middle - at.top - part(at.bottom - at.top, m);
  const Cosine h = part(long_rest - middle_bottom + top_middle, m) - top_middle;
  const Cosine g_top = across + top_middle - long_m;  // G at the three vertices
  const Cosine g_bottom = across + middle_bottom - long_rest;
  const Cosine g_middle = g_top + part(g_bottom - g_top, m) + h + h;
  const InverseLength pixel = InverseLength::of(inverse_width(frame), 16);
  scalar.second_difference = pixel.times(h + h, pixel);
  if (!frame.middle_left) {
    scalar.left = make_patch_edge(frame.long_edge, pixel, {at.top, g_top}, {at.bottom, g_bottom}, top_bottom);
    return;
  }
  // q runs from right to left.
  if (frame.has_upper) {
    scalar.left =
        make_patch_edge(frame.upper_edge, pixel, {at.top, -g_top}, {at.middle, -g_middle}, top_middle);
  }
  if (frame.has_lower) {
    scalar.lower = make_patch_edge(frame.lower_edge, pixel, {at.middle, -g_middle}, {at.bottom, -g_bottom},
                                   middle_bottom);
  }
}

}  // namespace arcspan::literature
