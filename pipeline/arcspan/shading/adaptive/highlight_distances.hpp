// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/highlight_table.hpp>
#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/shading/patch/sagitta_factor.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// True if a highlight's distance is linear in the normal: its sagittas then follow from those of N·H.
template <class Lighting>
[[nodiscard]] constexpr bool has_linear_distance(const Lighting& lighting) {
  return lighting.model() == Highlight::kBlinn;
}

/// The half distances (PowerTable) of a highlight over a triangle: at the vertices and, unless
/// has_linear_distance(), half-way along the edges.
struct HalfDistances {
  std::int32_t top;
  std::int32_t middle;
  std::int32_t bottom;
  std::int32_t top_middle = 0;
  std::int32_t top_bottom = 0;
  std::int32_t middle_bottom = 0;
  std::int32_t farthest = 0;  ///< the largest one
};

/// Returns the half distances of a light's highlight over a TriangleFrame; `factors` are used unless
/// has_linear_distance().
template <class Lighting, class Frame>
[[nodiscard]] ARCSPAN_INLINE constexpr HalfDistances half_distances_of(const Lighting& lighting,
                                                                       const Frame& frame, std::size_t light,
                                                                       const EdgeSagittaFactors& factors) {
  const std::size_t other = Lighting::highlight_index(light);
  const auto& top = frame.top->shade.scalars;
  const auto& middle = frame.middle->shade.scalars;
  const auto& bottom = frame.bottom->shade.scalars;
  HalfDistances half;
  const auto distance = [&](Cosine at_light, Cosine at_other) {
    const std::int32_t here = lighting.half_distance(at_light, at_other, light);
    if (here > half.farthest) half.farthest = here;
    return here;
  };
  if (!has_linear_distance(lighting)) {
    const auto half_way = [&](const auto& a, const auto& b, SagittaFactor factor) {
      const auto middle_of = [&](std::size_t i) {
        return detail::patch_middle(a[i], b[i], detail::quadruple_sagitta(a[i], b[i], factor));
      };
      return distance(middle_of(light), middle_of(other));
    };
    half.top_middle = half_way(top, middle, factors.top_middle);
    half.top_bottom = half_way(top, bottom, factors.top_bottom);
    half.middle_bottom = half_way(middle, bottom, factors.middle_bottom);
  }
  half.top = distance(top[light], top[other]);
  half.middle = distance(middle[light], middle[other]);
  half.bottom = distance(bottom[light], bottom[other]);
  return half;
}

/// Makes the surface of the scaled distances of a light's highlight; `table` fits() the farthest of them.
template <class Lighting, class Frame>
ARCSPAN_INLINE constexpr void make_distance_surface(const Lighting& lighting, const Frame& frame,
                                                    std::size_t light, const EdgeSagittaFactors& factors,
                                                    const HalfDistances& half, PatchScalar& scalar) {
  const HighlightTable& table = lighting.highlight_table();
  const auto scaled = [&table](std::int32_t distance) { return Cosine::from_raw(table.scaled(distance)); };
  const PatchValues at{scaled(half.top), scaled(half.middle), scaled(half.bottom)};
  EdgeQuadrupleSagittas sagittas;
  if (has_linear_distance(lighting)) {
    // The distance falls by half of what N·H rises. An eighth of a sagitta, up to 30 degrees below 2^25,
    // fits every table.
    const auto sagitta = [&](const auto& a, const auto& b, SagittaFactor factor) {
      const std::size_t other = Lighting::highlight_index(light);
      const Cosine whole =
          detail::quadruple_sagitta(a->shade.scalars[other], b->shade.scalars[other], factor);
      return -Cosine::from_raw(wrap_shl(table.scaled(whole.raw() >> 3), 2));
    };
    sagittas = {sagitta(frame.top, frame.middle, factors.top_middle),
                sagitta(frame.top, frame.bottom, factors.top_bottom),
                sagitta(frame.middle, frame.bottom, factors.middle_bottom)};
  } else {
    sagittas = {detail::quadruple_sagitta_through(at.top, at.middle, scaled(half.top_middle)),
                detail::quadruple_sagitta_through(at.top, at.bottom, scaled(half.top_bottom)),
                detail::quadruple_sagitta_through(at.middle, at.bottom, scaled(half.middle_bottom))};
  }
  make_patch_surface(frame, at, sagittas, scalar);
}

}  // namespace arcspan
