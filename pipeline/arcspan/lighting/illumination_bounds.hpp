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
constexpr bool Illumination<Lights, Model, Features>::may_shine_between(const Scalars& a, const Scalars& b,
                                                                        Factor angle2) const
    requires(Lights == 1) {
  const auto rough = [this](const Scalars& at) {  // factors rounded down, which costs less than rounding
    if constexpr (Model == Highlight::kBlinn) return highlight_distance(at[0], at[1], 0);
    return wrap_sub(half_one_plus_light_eye_[0], wrap_mul(at[0].raw() >> 15, at[1].raw() >> 15));
  };
  return detail::nearest_between(rough(a), rough(b), angle2) < power_.half_reach();
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
