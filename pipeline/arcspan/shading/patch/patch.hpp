// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstdint>

/// A scalar of a triangle whose normals are close together, as the quadratic surface through its vertices and
/// the middles of its three arcs (decision 5):
///
///     f = sum I_i l_i + sum b_ij l_i l_j,     b_ij = 2 (I_i + I_j) (1 / cos(psi_ij / 2) - 1),
///
/// l being the barycentric coordinates. Along an edge it depends on that edge alone, so that neighbours
/// agree. Down the left edge and along the rows it goes by second differences: nothing is left to multiply.
namespace arcspan {

/// A scalar on its way down a left edge. `slope` is its derivative along x there, per pixel.
struct PatchEdge {
  Cosine at;
  Cosine step;
  Cosine second_difference;
  Cosine slope;
  Cosine slope_step;

  /// Member by member: a call of memcpy costs more where there are few registers.
  constexpr void become(const PatchEdge& other) {
    at = other.at;
    step = other.step;
    second_difference = other.second_difference;
    slope = other.slope;
    slope_step = other.slope_step;
  }

  constexpr void advance() {
    at += step;
    step += second_difference;
    slope += slope_step;
  }
};

/// A scalar over a triangle: `lower` takes the left edge's place at the middle row if the middle vertex is on
/// the left; `second_difference` is the second difference from pixel to pixel.
struct PatchScalar {
  PatchEdge left;
  Cosine second_difference;
  PatchEdge lower;
};

template <std::size_t Count>
using Patch = std::array<PatchScalar, Count>;

/// The largest patch in pixels, either way: rounding of second differences adds up to 2^-17, which moves a
/// highlight of n = 64 by half an 8-bit step.
inline constexpr std::int32_t kLargestPatch = 128;

/// 4 (1 / cos(psi/2) - 1) of a squared chord s (28 fraction bits, at most 0.078, which is 16 degrees), which
/// is s/2 + 3/32 s^2 + ..., below 0.041.
using SagittaFactor = Fixed<std::int32_t, 20>;
[[nodiscard]] constexpr SagittaFactor sagitta_factor(std::uint32_t chord) {
  const std::uint32_t coarse = chord >> 10;  // 18 fraction bits
  return SagittaFactor::from_raw(
      static_cast<std::int32_t>(((chord + 256) >> 9) + ((3 * (coarse * coarse)) >> 21)));
}

namespace detail {

/// v * f rounded down, 0 <= f <= 2, to all 30 bits in two products: errors of a patch's parts are errors of
/// the normal's length, to which highlights are most sensitive.
[[nodiscard]] constexpr Cosine part(Cosine v, Factor f) {
  return Cosine::from_raw(scaled_down(v.raw(), static_cast<std::uint32_t>(f.raw()), Factor::kFraction));
}

/// 1 / length = fraction * 2^-down.
struct PatchStep {
  Factor fraction;
  int down;
};

/// Of a length of at least 1/2, given by its reciprocal with `bits` fraction bits.
[[nodiscard]] constexpr PatchStep patch_step(const Reciprocal& inverse, int bits) {
  const int down = inverse.exponent - bits - 16;
  const std::uint32_t fraction = inverse.mantissa >> 1;
  if (down >= 0) return {Factor::from_raw(static_cast<std::int32_t>(fraction)), down};
  return {Factor::from_raw(static_cast<std::int32_t>(fraction << -down)), 0};
}

/// v / length.
[[nodiscard]] constexpr Cosine per_step(Cosine v, const PatchStep& step) {
  return Cosine::from_raw(part(v, step.fraction).raw() >> step.down);
}

/// v / (length of one) / (length of the other), rounded to nearest: it is summed over and over.
[[nodiscard]] constexpr Cosine per_steps(Cosine v, const PatchStep& one, const PatchStep& other) {
  const Cosine product = part(part(v, one.fraction), other.fraction);
  const int down = one.down + other.down;
  return down == 0 ? product : Cosine::from_raw(round_shift(product.raw(), down > 31 ? 31 : down));
}

}  // namespace detail

/// Of a triangle's edges, in common to its scalars.
struct EdgeSagittaFactors {
  SagittaFactor top_middle;
  SagittaFactor top_bottom;
  SagittaFactor middle_bottom;
};

/// A scalar at the vertices.
struct PatchValues {
  Cosine top;
  Cosine middle;
  Cosine bottom;
};

/// How far a patch may rise above its vertices: sum b_ij l_i l_j <= b / 3 < 1/64.
inline constexpr Cosine kPatchHeadroom = Cosine::of(1.0 / 64);

/// Slivers have slopes too steep for a Cosine, and large triangles too many steps for the rounding.
template <class Method>
[[nodiscard]] constexpr bool patch_fits(const TriangleFrame<Method>& frame) {
  return frame.width >= (1u << 15) && frame.width < (static_cast<std::uint32_t>(kLargestPatch) << 16) &&
         frame.long_edge.dy < (kLargestPatch << Subpixel::kFraction);
}

namespace detail {

/// A scalar at one end of an edge: its value, and its slope over the widest row.
struct PatchEnd {
  Cosine value;
  Cosine slope;
};

/// b of an edge between the values p and q.
[[nodiscard]] constexpr Cosine quadruple_sagitta(Cosine p, Cosine q, SagittaFactor sagitta4) {
  const Factor mean = Factor::from_raw(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15);
  return multiply<Cosine>(mean, sagitta4);
}

/// The value half-way along an edge, which rises by b / 4 above its chord.
[[nodiscard]] constexpr Cosine patch_middle(Cosine p, Cosine q, Cosine rise) {
  return Cosine::from_raw(wrap_add(wrap_add(p.raw() >> 1, q.raw() >> 1), rise.raw() >> 2));
}

/// b of an edge from the value half-way along it.
[[nodiscard]] constexpr Cosine quadruple_sagitta_through(Cosine p, Cosine q, Cosine middle) {
  const std::int32_t above = wrap_sub(wrap_sub(middle.raw(), p.raw() >> 1), q.raw() >> 1);
  return Cosine::from_raw(wrap_shl(above, 2));
}

/// Sets a scalar off down an edge; `pixel` is one pixel of the widest row.
constexpr void make_patch_edge(const EdgeSetup& edge, const PatchStep& pixel, const PatchEnd& from,
                               const PatchEnd& to, Cosine sagitta4, PatchEdge& e) {
  // f(t) = from + t (to - from + sagitta4) - t^2 sagitta4.
  const Factor t = start_fraction(edge);
  const Cosine rise = to.value - from.value + sagitta4;
  const Cosine sag = part(sagitta4, t);
  const Cosine turn = to.slope - from.slope;
  e.at = from.value + part(rise - sag, t);
  e.slope = per_step(from.slope + part(turn, t), pixel);
  if (edge.dy < 1 << Subpixel::kFraction) {  // it has one row
    e.step = e.second_difference = e.slope_step = Cosine{};
    return;
  }
  const PatchStep row = patch_step(edge.inverse, Subpixel::kFraction);
  e.second_difference = -per_steps(sagitta4 + sagitta4, row, row);
  e.step = per_step(rise - sag - sag, row) + Cosine::from_raw(e.second_difference.raw() >> 1);
  e.slope_step = per_steps(turn, row, pixel);
}

}  // namespace detail

/// What a scalar rises above its chords: b of the three edges.
struct QuadrupleSagittas {
  Cosine top_middle;
  Cosine top_bottom;
  Cosine middle_bottom;
};

/// Makes one scalar of a patch. With t the fraction of the height and q that of the widest row, which is at
/// t = m, the barycentric coordinates are l_middle = q, l_bottom = t - m q, and f = F(t) + q G(t) + q^2 H.
template <class Method>
ARCSPAN_INLINE constexpr void make_patch_surface(const TriangleFrame<Method>& frame, const PatchValues& at,
                                                 const QuadrupleSagittas& rises, PatchScalar& scalar) {
  using detail::part;
  const Factor m = frame.middle_fraction;
  const Cosine above = part(rises.top_bottom, m);
  const Cosine below = rises.top_bottom - above;
  const Cosine across = at.middle - at.top - part(at.bottom - at.top, m);
  const Cosine h = part(below - rises.middle_bottom + rises.top_middle, m) - rises.top_middle;
  // G at the three vertices.
  Cosine g_top = across + rises.top_middle - above;
  Cosine g_bottom = across + rises.middle_bottom - below;
  Cosine g_middle = g_top + part(g_bottom - g_top, m) + h + h;
  const detail::PatchStep pixel = detail::patch_step(frame.inverse_width, 16);
  scalar.second_difference = detail::per_steps(h + h, pixel, pixel);
  if (!frame.middle_left) {
    detail::make_patch_edge(frame.long_edge, pixel, {at.top, g_top}, {at.bottom, g_bottom}, rises.top_bottom,
                            scalar.left);
    return;
  }
  // q runs from right to left.
  g_top = -g_top;
  g_middle = -g_middle;
  g_bottom = -g_bottom;
  if (frame.has_upper) {
    detail::make_patch_edge(frame.upper_edge, pixel, {at.top, g_top}, {at.middle, g_middle}, rises.top_middle,
                            scalar.left);
  }
  if (frame.has_lower) {
    detail::make_patch_edge(frame.lower_edge, pixel, {at.middle, g_middle}, {at.bottom, g_bottom},
                            rises.middle_bottom, scalar.lower);
  }
}

/// The same for a scalar that is linear in the normal.
template <class Method>
constexpr void make_patch_scalar(const TriangleFrame<Method>& frame,
                                 const EdgeSagittaFactors& sagitta_factors, const PatchValues& at,
                                 PatchScalar& scalar) {
  make_patch_surface(frame, at,
                     {detail::quadruple_sagitta(at.top, at.middle, sagitta_factors.top_middle),
                      detail::quadruple_sagitta(at.top, at.bottom, sagitta_factors.top_bottom),
                      detail::quadruple_sagitta(at.middle, at.bottom, sagitta_factors.middle_bottom)},
                     scalar);
}

}  // namespace arcspan
