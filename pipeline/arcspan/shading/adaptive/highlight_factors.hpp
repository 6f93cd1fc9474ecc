// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/raise_patch.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// The half distance of a highlight R·V, (1 + L·V) / 2 - (N·L)(N·V), in the scale of HighlightTable (decision
/// 7). It is computed from its factors where normals are too far apart for a surface of its own.
namespace arcspan {

/// True if the highlight of `Lighting` may be R·V. Some illuminations know that at run time only.
template <class Lighting>
inline constexpr bool kMayReflect = !requires {
  requires(Lighting::kModel == Highlight::kBlinn);
};

/// The factors of the half distance at a pixel: N·L, and N·V in the scale of distances. Both are raised by
/// kHalf, so that a shift rounds them to nearest.
struct HighlightFactors {
  static constexpr Cosine kHalf = Cosine::from_raw(1 << 14);

  Cosine light;
  Cosine eye;

  /// Returns the scaled distance; `origin` is product_origin().
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t distance_from(std::int32_t origin) const {
    return wrap_sub(origin, wrap_mul(light.raw() >> 15, eye.raw() >> 15));
  }
};

/// Returns (1 + L·V) / 2 of a light with the highlight R·V as a scaled distance.
template <class Lighting>
[[nodiscard]] constexpr std::int32_t product_origin(const Lighting& lighting, std::size_t light) {
  const Cosine half_one_plus_light_eye = Cosine::from_raw(lighting.half_distance({}, {}, light));
  return lighting.highlight_table().scaled_factor(half_one_plus_light_eye).raw();
}

/// Returns a scalar of the vertices of a TriangleFrame.
template <class Frame>
[[nodiscard]] constexpr PatchValues values_of(const Frame& frame, std::size_t scalar) {
  return {frame.top->shade.scalars[scalar], frame.middle->shade.scalars[scalar],
          frame.bottom->shade.scalars[scalar]};
}

/// Returns N·V of the vertices of a TriangleFrame in the scale of distances, for the highlight of a light.
template <class Lighting, class Frame>
[[nodiscard]] constexpr PatchValues scaled_eye_of(const Lighting& lighting, const Frame& frame,
                                                  std::size_t light) {
  const PatchValues eye = values_of(frame, Lighting::highlight_index(light));
  const HighlightTable& table = lighting.highlight_table();
  return {table.scaled_factor(eye.top), table.scaled_factor(eye.middle), table.scaled_factor(eye.bottom)};
}

/// Makes the patch of one of the HighlightFactors over a TriangleFrame.
template <class Frame>
constexpr void make_factor_surface(const Frame& frame, const EdgeSagittaFactors& factors,
                                   const PatchValues& values, PatchScalar& scalar) {
  make_patch_scalar(frame, factors, values, scalar);
  raise_patch_scalar(frame, HighlightFactors::kHalf, scalar);
}

}  // namespace arcspan
