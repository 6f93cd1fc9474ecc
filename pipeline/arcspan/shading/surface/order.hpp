// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/shading/surface/chords.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// How the scalars of a triangle are interpolated, from the cheapest to the exact one.
enum class SurfaceOrder : std::uint8_t {
  kLinear,      ///< by planes: within the tolerance, or no light reaches the triangle
  kQuadratic,   ///< by quadratic surfaces through the arcs' middles
  kNormalised,  ///< by planes divided by the length of the linear normal: Phong's, for any angle and any size
};

/// The order of a triangle, and what light reaches it.
struct SurfaceChoice {
  SurfaceOrder order;
  TriangleLight light;
  NormalChords chords;
};

/// Returns true if the quadratic surfaces of a triangle are as accurate as those of an equilateral one with
/// the squared chord `limit` (28 fraction bits). The error grows with the cube of the angle. Of triangles
/// with the same widest chord, those with a right angle have less than half of the equilateral one's error.
[[nodiscard]] constexpr bool is_accurate_quadratic(const NormalChords& chords, std::uint32_t limit) {
  const std::uint32_t widest = chords.widest();
  if (widest <= limit) return true;
  return (widest >> 1) + (widest >> 3) <= limit && widest <= kWidestQuadratic &&
         chords.sum() - widest <= limit + (limit >> 1) + (limit >> 3);
}

/// The cheapest order but linear.
[[nodiscard]] constexpr SurfaceOrder round_order(const SurfaceChoice& choice, bool may_bend) {
  return may_bend && is_accurate_quadratic(choice.chords, choice.light.quadratic_limit)
             ? SurfaceOrder::kQuadratic
             : SurfaceOrder::kNormalised;
}

/// Chooses the order of a triangle. `may_bend` is false if it may not be quadratic, because it is small or
/// too large.
///
/// A cut triangle (SurfaceVertex) and one with normals more than 60 degrees apart are always normalised
/// unless they are dark, because the bounds of the light do not hold for them.
template <class Lighting, std::size_t Count>
[[nodiscard]] constexpr SurfaceChoice choose_order(const Lighting& lighting, const SurfaceVertex<Count>& top,
                                                   const SurfaceVertex<Count>& middle,
                                                   const SurfaceVertex<Count>& bottom, bool may_bend) {
  SurfaceChoice choice;
  choice.order = SurfaceOrder::kLinear;
  choice.light.reach = LightReach::kNone;
  if (lighting.is_dark(top.scalars, middle.scalars, bottom.scalars)) return choice;
  choice.order = SurfaceOrder::kNormalised;
  choice.light.reach = LightReach::kHighlight;
  choice.chords = {squared_chord(top.normal, middle.normal), squared_chord(top.normal, bottom.normal),
                   squared_chord(middle.normal, bottom.normal)};
  const std::uint32_t widest = choice.chords.widest();
  if (widest > kWidestBounded || (top.deficit | middle.deficit | bottom.deficit) != 0) return choice;
  choice.light = lighting.light_over(top.scalars, middle.scalars, bottom.scalars, widest);
  choice.order = choice.light.linear ? SurfaceOrder::kLinear : round_order(choice, may_bend);
  return choice;
}

}  // namespace arcspan
