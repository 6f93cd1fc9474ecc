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
constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_highlight(const Scalars& a,
                                                                                const Scalars& b,
                                                                                const Scalars& c,
                                                                                Cosine headroom) const {
  std::int32_t nearest = INT32_MAX;
  for (std::size_t i = 0; i < Lights; ++i) {
    const std::int32_t distance = nearest_highlight_of(i, a, b, c, headroom);
    if (distance < nearest) nearest = distance;
  }
  return nearest;
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

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::nearest_between(std::int32_t at_a,
                                                                              std::int32_t at_b,
                                                                              Factor angle2) {
  // On an arc of the angle psi the half distance is a cosine of 2 psi with the amplitude 1/2 at most (R·V;
  // N·H: less). Its second derivative by the angle is at most 2, so that it is below the chord by at most
  // v (1 - v) psi^2, and below the lesser end by a quarter of what psi^2 exceeds the difference of the ends.
  const std::int32_t difference = at_a < at_b ? wrap_sub(at_b, at_a) : wrap_sub(at_a, at_b);
  const std::int32_t excess = wrap_sub(wrap_shl(angle2.raw(), 15), difference);
  constexpr std::int32_t kOfParabola = std::int32_t{1} << 21;  // for the error of the parabola that is drawn
  return wrap_sub(at_a < at_b ? at_a : at_b, (excess < 0 ? 0 : excess >> 2) + kOfParabola);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::half_distance(Cosine normal_light, Cosine other,
                                                                            std::size_t light) const {
  if constexpr (Model == Highlight::kBlinn) {
    return highlight_distance(normal_light, other, light);
  } else {
    const std::int32_t product = multiply_high(normal_light.raw(), other.raw());
    return wrap_sub(half_one_plus_light_eye_[light], wrap_shl(product, 2));
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr bool Illumination<Lights, Model, Features>::may_clamp(bool shines) const {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t lit =  // 5 fraction bits
        (diffuse_[c] + (shines ? specular_[c] : 0)) * static_cast<std::uint32_t>(Lights);
    if ((ambient_[c] >> 15) + lit >= 255u << 5) return true;
  }
  return false;
}

}  // namespace arcspan
