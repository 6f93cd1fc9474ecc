// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <cstddef>
#include <cstdint>

/// Bounds of the light over a triangle, by which shading methods choose a path.
namespace arcspan {

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr bool Illumination<Lights, Model, Features>::lit_throughout(const Scalars& a, const Scalars& b,
                                                                     const Scalars& c,
                                                                     std::uint32_t& lit) const {
  lit = 0;
  if constexpr (Lights > 1) {
    for (std::size_t i = 0; i < Lights; ++i) {
      const bool any = a[i].raw() > 0 || b[i].raw() > 0 || c[i].raw() > 0;
      if (any && (a[i].raw() | b[i].raw() | c[i].raw()) < 0) return false;
      lit |= static_cast<std::uint32_t>(any) << i;
    }
  }
  return true;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_highlight_of(
    std::size_t light, const Scalars& a, const Scalars& b, const Scalars& c, Cosine headroom) const {
  const auto highest = [&](std::size_t i) {
    const Cosine upper = a[i] > b[i] ? a[i] : b[i];
    const Cosine most = (upper > c[i] ? upper : c[i]) + headroom;
    return most.raw() < 0 ? Cosine{} : most;
  };
  const Cosine most_light = highest(light);
  if (most_light.raw() == 0) return INT32_MAX;
  return highlight_distance(most_light, highest(highlight_index(light)), light);
}

}  // namespace arcspan
