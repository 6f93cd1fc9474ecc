// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/lighting/pixel_light.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace arcspan {

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr PackedRgb Illumination<Lights, Model, Features>::highlight(
    std::uint32_t power) const {
  const auto share = [power](std::uint32_t coefficient) {
    const std::uint32_t level = (coefficient * power) >> 18;
    return Lights == 1 || level < 1023 ? level : 1023u;  // several highlights may coincide
  };
  if (white_specular_ != 0) return PackedRgb::grey(share(white_specular_));
  return PackedRgb::of(share(specular_[0]), share(specular_[1]), share(specular_[2]));
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr PixelLight Illumination<Lights, Model, Features>::light(
    const Scalars& scalars) const {
  if constexpr (Lights == 1) {
    const PackedRgb ramp = diffuse_colour(scalars[0]);
    const std::int32_t half_distance = highlight_distance(scalars[0], scalars[1], 0);
    if (half_distance >= power_.half_reach() || scalars[0].raw() <= 0) return {ramp, {}};
    return {ramp, highlight(fade()(power_(half_distance), scalars[0]))};
  } else if constexpr (kHasRamp) {
    GreySums sums;
    add_grey_lights(scalars, sums, std::make_index_sequence<Lights>{});
    const PackedRgb ramp = diffuse_colour(Cosine::from_raw(static_cast<std::int32_t>(sums.diffuse)));
    return {ramp, sums.power == 0 ? PackedRgb{} : highlight(sums.power)};
  } else {
    return {colour(scalars), {}};
  }
}

}  // namespace arcspan
