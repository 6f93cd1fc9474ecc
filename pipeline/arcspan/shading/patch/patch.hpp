// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/shading/patch/inverse_length.hpp>
#include <arcspan/shading/patch/patch_limits.hpp>
#include <arcspan/shading/patch/sagitta_factor.hpp>
#include <arcspan/shading/patch/second_difference_parts.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

/// A patch replaces the arcs of a triangle whose normals are close together (decision 5). Each scalar is the
/// quadratic surface through its values at the three vertices and at the middles of the three arcs:
///
///     f = sum I_i l_i + sum b_ij l_i l_j,     b_ij = 2 (I_i + I_j) (1 / cos(psi_ij / 2) - 1),
///
/// where l are the barycentric coordinates. b_ij is the *quadruple sagitta* of an edge: four times the height
/// of the arc above its chord at the middle, b = 4 (f(1/2) - (I_i + I_j) / 2). For a scalar that is linear in
/// the normal, S0 eq. 2 gives f(1/2) = (I_i + I_j) / (2 cos(psi_ij / 2)), hence the formula.
///
/// Along an edge f depends on that edge alone, so that neighbouring triangles agree. Down the left edge and
/// along the rows f is stepped by second differences, without a multiply.
namespace arcspan {

/// A scalar along a left edge, at the current row.
struct PatchEdge {
  Cosine at;                 ///< value on the edge, at the row's centre line
  Cosine step;               ///< difference to the next row
  Cosine second_difference;  ///< change of `step` per row
  Cosine slope;              ///< derivative along x on the edge, per pixel
  Cosine slope_step;         ///< change of `slope` per row

  /// Assigns member by member, because a call of memcpy costs more on cores with few registers.
  constexpr void become(const PatchEdge& other) {
    at = other.at;
    step = other.step;
    second_difference = other.second_difference;
    slope = other.slope;
    slope_step = other.slope_step;
  }

  ARCSPAN_INLINE constexpr void advance() {
    at += step;
    step += second_difference;
    slope += slope_step;
  }
  /// Steps `rows` rows at once; the result is bit-identical to that of `rows` calls of advance().
  constexpr void advance(std::int32_t rows) {
    const std::int32_t pairs = (rows * (rows - 1)) >> 1;
    at += Cosine::from_raw(wrap_add(wrap_mul(step.raw(), rows), wrap_mul(second_difference.raw(), pairs)));
    step += Cosine::from_raw(wrap_mul(second_difference.raw(), rows));
    slope += Cosine::from_raw(wrap_mul(slope_step.raw(), rows));
  }
};

/// A scalar over a triangle. At the middle row `lower` replaces `left` if the middle vertex is on the left.
struct PatchScalar {
  PatchEdge left;
  Cosine second_difference;  ///< per pixel along a row; the same for all rows
  PatchEdge lower;
  [[no_unique_address]] SecondDifferenceParts parts;
};

/// The patch of a triangle: `Count` scalars.
template <std::size_t Count>
using Patch = std::array<PatchScalar, Count>;

/// The values of a scalar at the vertices.
struct PatchValues {
  Cosine top;
  Cosine middle;
  Cosine bottom;
};

namespace detail {

/// A scalar at one end of an edge: its value, and its derivative along x per length of the widest row.
struct PatchEnd {
  Cosine value;
  Cosine slope;
};

/// Returns the quadruple sagitta of an edge between the values p and q.
[[nodiscard]] ARCSPAN_INLINE constexpr Cosine quadruple_sagitta(Cosine p, Cosine q, SagittaFactor factor) {
  const Factor mean = Factor::from_raw(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15);
  return multiply<Cosine>(mean, factor);
}

/// Returns the value half-way along an edge: the mean of its ends, plus a quarter of the quadruple sagitta.
[[nodiscard]] constexpr Cosine patch_middle(Cosine p, Cosine q, Cosine sagitta4) {
  return Cosine::from_raw(wrap_add(wrap_add(p.raw() >> 1, q.raw() >> 1), sagitta4.raw() >> 2));
}

/// Returns the quadruple sagitta of an edge between p and q with the value `middle` half-way along it.
[[nodiscard]] constexpr Cosine quadruple_sagitta_through(Cosine p, Cosine q, Cosine middle) {
  const std::int32_t above = wrap_sub(wrap_sub(middle.raw(), p.raw() >> 1), q.raw() >> 1);
  return Cosine::from_raw(wrap_shl(above, 2));
}

/// Sets up a scalar along an edge at the edge's first row. `from` is its upper end, `to` its lower end,
/// `sagitta4` its quadruple sagitta, and `pixel` the inverse width of the widest row in pixels.
ARCSPAN_OUTLINE_IF_TIGHT constexpr void make_patch_edge(const EdgeSetup& edge, const InverseLength& pixel,
                                                        const PatchEnd& from, const PatchEnd& to,
                                                        Cosine sagitta4, PatchEdge& e) {
  // f(t) = from + t (to - from + sagitta4) - t^2 sagitta4, t = 0...1 along the edge.
  const Factor t = edge.start;
  const Cosine slope_at_top = to.value - from.value + sagitta4;
  const Cosine sagitta4_by_t = part(sagitta4, t);
  const Cosine slope_difference = to.slope - from.slope;
  e.at = from.value + part(slope_at_top - sagitta4_by_t, t);
  e.slope = divide_by_length(from.slope + part(slope_difference, t), pixel);
  if (edge.dy < 1 << Subpixel::kFraction) {  // the edge has one row
    e.step = e.second_difference = e.slope_step = Cosine{};
    return;
  }
  const InverseLength row = inverse_length(edge.inverse, Subpixel::kFraction);
  e.second_difference = -divide_by_both_lengths(sagitta4 + sagitta4, row, row);
  e.step = divide_by_length(slope_at_top - sagitta4_by_t - sagitta4_by_t, row) +
           Cosine::from_raw(e.second_difference.raw() >> 1);
  e.slope_step = divide_by_both_lengths(slope_difference, row, pixel);
}

}  // namespace detail

/// The quadruple sagittas of a scalar along a triangle's edges.
struct EdgeQuadrupleSagittas {
  Cosine top_middle;
  Cosine top_bottom;
  Cosine middle_bottom;
};

/// Makes one scalar of a patch from its values at the vertices and its quadruple sagittas. Let t be the
/// fraction of the triangle's height, m that of the middle vertex, and q the distance from the long edge as a
/// fraction of the widest row. Then the barycentric coordinates are l_middle = q and l_bottom = t - m q, and
/// f = F(t) + q G(t) + q^2 H.
template <class Method>
ARCSPAN_INLINE constexpr void make_patch_surface(const TriangleFrame<Method>& frame, const PatchValues& at,
                                                 const EdgeQuadrupleSagittas& sagittas, PatchScalar& scalar) {
  using detail::part;
  const Factor m = frame.middle_fraction;
  const Cosine long_m = part(sagittas.top_bottom, m);
  const Cosine long_rest = sagittas.top_bottom - long_m;
  const Cosine across = at.middle - at.top - part(at.bottom - at.top, m);
  const Cosine h = part(long_rest - sagittas.middle_bottom + sagittas.top_middle, m) - sagittas.top_middle;
  // G at the three vertices; `across` is how far the middle vertex is above the long edge's chord.
  Cosine g_top = across + sagittas.top_middle - long_m;
  Cosine g_bottom = across + sagittas.middle_bottom - long_rest;
  Cosine g_middle = g_top + part(g_bottom - g_top, m) + h + h;
  const detail::InverseLength pixel = detail::inverse_length(frame.inverse_width, 16);
  scalar.second_difference = detail::divide_by_both_lengths(h + h, pixel, pixel);
  scalar.parts.set(scalar.second_difference);
  if (!frame.middle_left) {
    detail::make_patch_edge(frame.long_edge, pixel, {at.top, g_top}, {at.bottom, g_bottom},
                            sagittas.top_bottom, scalar.left);
    return;
  }
  // q runs from right to left.
  g_top = -g_top;
  g_middle = -g_middle;
  g_bottom = -g_bottom;
  if (frame.has_upper) {
    detail::make_patch_edge(frame.upper_edge, pixel, {at.top, g_top}, {at.middle, g_middle},
                            sagittas.top_middle, scalar.left);
  }
  if (frame.has_lower) {
    detail::make_patch_edge(frame.lower_edge, pixel, {at.middle, g_middle}, {at.bottom, g_bottom},
                            sagittas.middle_bottom, scalar.lower);
  }
}

/// Makes one scalar of a patch that is linear in the normal, from its values at the vertices.
template <class Method>
ARCSPAN_OUTLINE constexpr void make_patch_scalar(const TriangleFrame<Method>& frame,
                                                 const EdgeSagittaFactors& sagitta_factors,
                                                 const PatchValues& at, PatchScalar& scalar) {
  make_patch_surface(frame, at,
                     {detail::quadruple_sagitta(at.top, at.middle, sagitta_factors.top_middle),
                      detail::quadruple_sagitta(at.top, at.bottom, sagitta_factors.top_bottom),
                      detail::quadruple_sagitta(at.middle, at.bottom, sagitta_factors.middle_bottom)},
                     scalar);
}

}  // namespace arcspan
