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

/// Squared chord of 16 degrees, 28 fraction bits: a patch up to there is within 2.6e-4 of bilinear SLERP.
inline constexpr std::uint32_t kWidestPatch = 20797219u;

/// The largest patch in pixels, either way: rounding of second differences adds up to 2^-16.
inline constexpr std::int32_t kLargestPatch = 256;

/// Difference of a scalar over a whole edge or over the widest row: below 1/2, 16 bits.
using PatchDifference = Fixed<std::int32_t, 16>;

/// 4 (1 / cos(psi/2) - 1) of a squared chord s (28 fraction bits, at most kWidestPatch), which is
/// s/2 + 3/32 s^2 + ..., below 0.041.
using PatchBulge = Fixed<std::int32_t, 20>;
[[nodiscard]] constexpr PatchBulge patch_bulge(std::uint32_t chord) {
  const std::uint32_t coarse = chord >> 10;  // 18 fraction bits
  return PatchBulge::from_raw(
      static_cast<std::int32_t>(((chord + 256) >> 9) + ((3 * (coarse * coarse)) >> 21)));
}

/// b of an edge between the values p and q.
[[nodiscard]] constexpr PatchDifference patch_bulge_between(Unit p, Unit q, PatchBulge bulge) {
  const Factor mean = Factor::from_raw(wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15);
  return multiply<PatchDifference>(mean, bulge);
}

/// value / length as a Unit, where the length is given by its reciprocal with `bits` fraction bits and is at
/// least 1/2.
[[nodiscard]] constexpr Unit patch_slope(PatchDifference value, const Reciprocal& inverse, int bits) {
  const std::int32_t product = wrap_mul(value.raw(), static_cast<std::int32_t>(inverse.mantissa >> 1));
  return Unit::from_raw(product >> (inverse.exponent - 15 - bits));
}

/// The same divided by two lengths, times `2^up`; |value| below 1/8.
[[nodiscard]] constexpr Unit patch_bend(PatchDifference value, const Reciprocal& one, int one_bits,
                                        const Reciprocal& other, int other_bits, int up) {
  const std::int32_t once = wrap_mul(value.raw(), static_cast<std::int32_t>(one.mantissa >> 1));
  const std::int32_t twice = wrap_mul(once >> 12, static_cast<std::int32_t>(other.mantissa >> 1));
  const int down = one.exponent - one_bits + other.exponent - other_bits - 28 - up;
  return Unit::from_raw(round_shift(twice, down < 1 ? 1 : down > 31 ? 31 : down));
}

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

/// A scalar at one end of an edge: its value and its slope over the widest row.
struct PatchEnd {
  Unit value;
  PatchDifference slope;
};

[[nodiscard]] constexpr PatchDifference patch_difference(Unit from, Unit to) {
  return convert<PatchDifference>(to - from);
}

/// Sets a scalar off down an edge; `width` is the reciprocal of the widest row.
constexpr void make_patch_edge(const EdgeSpan& edge, const Reciprocal& width, const PatchEnd& from,
                               const PatchEnd& to, PatchDifference bulge, PatchEdge& e) {
  const Factor t = start_fraction(edge);
  const PatchDifference rise = patch_difference(from.value, to.value) + bulge;
  const PatchDifference sag = multiply<PatchDifference>(t, bulge);
  const PatchDifference turn = to.slope - from.slope;
  e.at = from.value + multiply<Unit>(t, rise - sag);
  e.slope = patch_slope(from.slope + multiply<PatchDifference>(t, turn), width, 16);
  if (edge.dy < 1 << Subpixel::kFraction) {  // it has one row
    e.step = e.bend = e.slope_step = Unit{};
    return;
  }
  constexpr int kBits = Subpixel::kFraction;
  e.bend = -patch_bend(bulge, edge.inverse, kBits, edge.inverse, kBits, 1);
  e.step = patch_slope(rise - sag - sag, edge.inverse, kBits) + Unit::from_raw(e.bend.raw() >> 1);
  e.slope_step = patch_bend(turn, edge.inverse, kBits, width, 16, 0);
}

}  // namespace detail

/// Makes one scalar of a patch. With t the fraction of the height and q that of the widest row, which is at
/// t = m, the barycentric coordinates are l_middle = q, l_bottom = t - m q, and f = F(t) + q G(t) + q^2 H.
template <class Method>
constexpr void make_patch_scalar(const TriangleFrame<Method>& frame, const PatchBulges& bulges,
                                 const PatchValues& at, PatchScalar& scalar) {
  const Factor m = frame.middle_fraction;
  const PatchDifference top_middle = patch_bulge_between(at.top, at.middle, bulges.top_middle);
  const PatchDifference middle_bottom = patch_bulge_between(at.middle, at.bottom, bulges.middle_bottom);
  const PatchDifference top_bottom = patch_bulge_between(at.top, at.bottom, bulges.top_bottom);
  const PatchDifference above = multiply<PatchDifference>(m, top_bottom);
  const PatchDifference below = top_bottom - above;
  const PatchDifference across = detail::patch_difference(at.top, at.middle) -
                                 multiply<PatchDifference>(m, detail::patch_difference(at.top, at.bottom));
  const PatchDifference h = multiply<PatchDifference>(m, below) - top_middle -
                            multiply<PatchDifference>(m, middle_bottom - top_middle);
  // G at the three vertices.
  PatchDifference g_top = across + top_middle - above;
  PatchDifference g_bottom = across + middle_bottom - below;
  PatchDifference g_middle = g_top + multiply<PatchDifference>(m, g_bottom - g_top) + h + h;
  scalar.bend = patch_bend(h, frame.inverse_width, 16, frame.inverse_width, 16, 1);
  if (!frame.middle_left) {
    detail::make_patch_edge(frame.long_edge, frame.inverse_width, {at.top, g_top}, {at.bottom, g_bottom},
                            top_bottom, scalar.left);
    return;
  }
  // q runs from right to left.
  g_top = -g_top;
  g_middle = -g_middle;
  g_bottom = -g_bottom;
  if (frame.has_upper) {
    detail::make_patch_edge(frame.upper_edge, frame.inverse_width, {at.top, g_top}, {at.middle, g_middle},
                            top_middle, scalar.left);
  }
  if (frame.has_lower) {
    detail::make_patch_edge(frame.lower_edge, frame.inverse_width, {at.middle, g_middle},
                            {at.bottom, g_bottom}, middle_bottom, scalar.lower);
  }
}

}  // namespace arcspan
