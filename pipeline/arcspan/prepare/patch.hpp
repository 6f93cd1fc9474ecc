// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/unroll.hpp>
#include <arcspan/prepare/triangle.hpp>

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
  Unit at;
  Unit step;
  Unit bend;
  Unit slope;
  Unit slope_step;

  /// Member by member: a call of memcpy costs more where there are few registers.
  constexpr void become(const PatchEdge& other) {
    at = other.at;
    step = other.step;
    bend = other.bend;
    slope = other.slope;
    slope_step = other.slope_step;
  }

  constexpr void advance() {
    at += step;
    step += bend;
    slope += slope_step;
  }
};

/// A scalar over a triangle: `lower` takes the left edge's place at the middle row if the middle vertex is on
/// the left; `bend` is the second difference from pixel to pixel.
struct PatchScalar {
  PatchEdge left;
  Unit bend;
  PatchEdge lower;
};

template <std::size_t Count>
using Patch = std::array<PatchScalar, Count>;

/// The largest patch in pixels, either way: rounding of second differences adds up to 2^-17, which moves a
/// highlight of n = 64 by half an 8-bit step.
inline constexpr std::int32_t kLargestPatch = 128;

/// 4 (1 / cos(psi/2) - 1) of a squared chord s (28 fraction bits, at most 0.078, which is 16 degrees), which
/// is s/2 + 3/32 s^2 + ..., below 0.041.
using PatchBulge = Fixed<std::int32_t, 20>;
[[nodiscard]] constexpr PatchBulge patch_bulge(std::uint32_t chord) {
  const std::uint32_t coarse = chord >> 10;  // 18 fraction bits
  return PatchBulge::from_raw(
      static_cast<std::int32_t>(((chord + 256) >> 9) + ((3 * (coarse * coarse)) >> 21)));
}

namespace detail {

/// v * f rounded down, 0 <= f <= 2, to all 30 bits in two products: errors of a patch's parts are errors of
/// the normal's length, to which highlights are most sensitive.
[[nodiscard]] constexpr Unit part(Unit v, Factor f) {
  return Unit::from_raw(scaled_down(v.raw(), static_cast<std::uint32_t>(f.raw()), Factor::kFraction));
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
[[nodiscard]] constexpr Unit per_step(Unit v, const PatchStep& step) {
  return Unit::from_raw(part(v, step.fraction).raw() >> step.down);
}

/// v / (length of one) / (length of the other), rounded to nearest: it is summed over and over.
[[nodiscard]] constexpr Unit per_steps(Unit v, const PatchStep& one, const PatchStep& other) {
  const Unit product = part(part(v, one.fraction), other.fraction);
  const int down = one.down + other.down;
  return down == 0 ? product : Unit::from_raw(round_shift(product.raw(), down > 31 ? 31 : down));
}

}  // namespace detail

/// Of a triangle's edges, in common to its scalars.
struct PatchBulges {
  PatchBulge top_middle;
  PatchBulge top_bottom;
  PatchBulge middle_bottom;
};

/// A scalar at the vertices.
struct PatchValues {
  Unit top;
  Unit middle;
  Unit bottom;
};

/// How far a patch may rise above its vertices: sum b_ij l_i l_j <= b / 3 < 1/64.
inline constexpr Unit kPatchHeadroom = Unit::of(1.0 / 64);

/// Slivers have slopes too steep for a Unit, and large triangles too many steps for the rounding.
template <class Method>
[[nodiscard]] constexpr bool patch_fits(const TriangleFrame<Method>& frame) {
  return frame.width >= (1u << 15) && frame.width < (static_cast<std::uint32_t>(kLargestPatch) << 16) &&
         frame.long_edge.dy < (kLargestPatch << Subpixel::kFraction);
}

namespace detail {

/// A scalar at one end of an edge: its value, and its slope over the widest row.
struct PatchEnd {
  Unit value;
  Unit slope;
};

/// b of an edge between the values p and q.
[[nodiscard]] constexpr Unit bulge_between(Unit p, Unit q, PatchBulge bulge) {
  const Factor mean = Factor::from_raw(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15);
  return multiply<Unit>(mean, bulge);
}

/// The value half-way along an edge, which rises by b / 4 above its chord.
[[nodiscard]] constexpr Unit patch_middle(Unit p, Unit q, Unit rise) {
  return Unit::from_raw(wrap_add(wrap_add(p.raw() >> 1, q.raw() >> 1), rise.raw() >> 2));
}

/// b of an edge from the value half-way along it.
[[nodiscard]] constexpr Unit rise_through(Unit p, Unit q, Unit middle) {
  const std::int32_t above = wrap_sub(wrap_sub(middle.raw(), p.raw() >> 1), q.raw() >> 1);
  return Unit::from_raw(wrap_shl(above, 2));
}

/// Sets a scalar off down an edge; `pixel` is one pixel of the widest row.
constexpr void make_patch_edge(const EdgeSpan& edge, const PatchStep& pixel, const PatchEnd& from,
                               const PatchEnd& to, Unit bulge, PatchEdge& e) {
  // f(t) = from + t (to - from + bulge) - t^2 bulge.
  const Factor t = start_fraction(edge);
  const Unit rise = to.value - from.value + bulge;
  const Unit sag = part(bulge, t);
  const Unit turn = to.slope - from.slope;
  e.at = from.value + part(rise - sag, t);
  e.slope = per_step(from.slope + part(turn, t), pixel);
  if (edge.dy < 1 << Subpixel::kFraction) {  // it has one row
    e.step = e.bend = e.slope_step = Unit{};
    return;
  }
  const PatchStep row = patch_step(edge.inverse, Subpixel::kFraction);
  e.bend = -per_steps(bulge + bulge, row, row);
  e.step = per_step(rise - sag - sag, row) + Unit::from_raw(e.bend.raw() >> 1);
  e.slope_step = per_steps(turn, row, pixel);
}

}  // namespace detail

/// What a scalar rises above its chords: b of the three edges.
struct PatchRises {
  Unit top_middle;
  Unit top_bottom;
  Unit middle_bottom;
};

/// Makes one scalar of a patch. With t the fraction of the height and q that of the widest row, which is at
/// t = m, the barycentric coordinates are l_middle = q, l_bottom = t - m q, and f = F(t) + q G(t) + q^2 H.
template <class Method>
[[gnu::always_inline]] constexpr void make_patch_surface(const TriangleFrame<Method>& frame,
                                                         const PatchValues& at, const PatchRises& rises,
                                                         PatchScalar& scalar) {
  using detail::part;
  const Factor m = frame.middle_fraction;
  const Unit above = part(rises.top_bottom, m);
  const Unit below = rises.top_bottom - above;
  const Unit across = at.middle - at.top - part(at.bottom - at.top, m);
  const Unit h = part(below - rises.middle_bottom + rises.top_middle, m) - rises.top_middle;
  // G at the three vertices.
  Unit g_top = across + rises.top_middle - above;
  Unit g_bottom = across + rises.middle_bottom - below;
  Unit g_middle = g_top + part(g_bottom - g_top, m) + h + h;
  const detail::PatchStep pixel = detail::patch_step(frame.inverse_width, 16);
  scalar.bend = detail::per_steps(h + h, pixel, pixel);
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
constexpr void make_patch_scalar(const TriangleFrame<Method>& frame, const PatchBulges& bulges,
                                 const PatchValues& at, PatchScalar& scalar) {
  make_patch_surface(frame, at,
                     {detail::bulge_between(at.top, at.middle, bulges.top_middle),
                      detail::bulge_between(at.top, at.bottom, bulges.top_bottom),
                      detail::bulge_between(at.middle, at.bottom, bulges.middle_bottom)},
                     scalar);
}

}  // namespace arcspan
