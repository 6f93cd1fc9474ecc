// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/unroll.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// The sums of Illumination over its lights. With a ramp() the diffuse colour is looked up by N·L, or by the
/// weighted sum of several grey lights.
namespace arcspan {

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr Cosine Illumination<Lights, Model, Features>::mean_light(const Scalars& scalars,
                                                                   [[maybe_unused]] std::uint32_t lit) const {
  if constexpr (Lights == 1) {
    return scalars[0];
  } else {
    Cosine sum{};
    for (std::size_t i = 0; i < Lights; ++i) {
      if ((lit >> i & 1u) != 0) sum += Cosine::from_raw(scaled_down(scalars[i].raw(), this->shares[i], 15));
    }
    return sum;
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::uint32_t Illumination<Lights, Model, Features>::ramp_range() const {
  if constexpr (Lights == 1) {
    return std::uint32_t{1} << 15;
  } else {
    return this->range;
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr void Illumination<Lights, Model, Features>::add_weighted(std::uint32_t value,
                                                                   const Weights& weights, Weights& sums) {
  unrolled<3>([&](auto c) { sums[c] += (value * weights[c] + (1u << 14)) >> 15; });
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr void Illumination<Lights, Model, Features>::add_grey_light(std::size_t light,
                                                                                    const Scalars& scalars,
                                                                                    GreySums& sums) const {
  const std::uint32_t diffuse = not_negative(scalars[light]);
  if (diffuse == 0) return;
  sums.diffuse += diffuse * this->shares[light];
  const std::int32_t half_distance =
      highlight_distance(scalars[light], highlight_scalar(scalars, light), light);
  if (half_distance >= power_.half_reach()) return;
  sums.power += (fade()(power_(half_distance), scalars[light]) * weights_[light] + (1u << 14)) >> 15;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <std::size_t Count>
ARCSPAN_INLINE constexpr Cosine Illumination<Lights, Model, Features>::diffuse_sum(
    const std::array<Cosine, Count>& scalars) const requires(kHasRamp&& Lights > 1 && Count >= Lights) {
  std::uint32_t sum = 0;
  unrolled<Lights>([&](auto i) { sum += not_negative(scalars[i]) * this->shares[i]; });
  return Cosine::from_raw(static_cast<std::int32_t>(sum));
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr auto Illumination<Lights, Model, Features>::light_sums(const Scalars& scalars) const -> LightSums {
  LightSums sums;
  unrolled<Lights>([&](auto i) {
    const std::uint32_t diffuse = clamped(scalars[i]);
    if (diffuse == 0) return;
    const std::int32_t half_distance = highlight_distance(scalars[i], highlight_scalar(scalars, i), i);
    const std::uint32_t specular =
        half_distance < power_.half_reach() ? fade()(power_(half_distance), scalars[i]) : 0;
    if constexpr (Lights == 1) {
      sums = {diffuse, specular};
    } else if constexpr (!kWeighsChannels) {
      sums.diffuse += (diffuse * weights_[i] + (1u << 14)) >> 15;
      sums.specular += (specular * weights_[i] + (1u << 14)) >> 15;
    } else {
      add_weighted(diffuse, weights_[i], sums.diffuse);
      if (specular != 0) add_weighted(specular, weights_[i], sums.specular);
    }
  });
  return sums;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::uint32_t Illumination<Lights, Model, Features>::channel(std::size_t c,
                                                                       const LightSums& sums) const {
  if constexpr (kWeighsChannels) {
    return ambient_[c] + diffuse_[c] * sums.diffuse[c] + specular_[c] * sums.specular[c];
  } else {
    return ambient_[c] + diffuse_[c] * sums.diffuse + specular_[c] * sums.specular;
  }
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::uint32_t Illumination<Lights, Model, Features>::level(std::size_t c,
                                                                     const LightSums& sums) const {
  const std::uint32_t rounded = (channel(c, sums) + (std::uint32_t{1} << 19)) >> 18;
  return rounded > 1023 ? 1023 : rounded;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr std::int32_t Illumination<Lights, Model, Features>::deep_level(std::size_t c,
                                                                         const LightSums& sums) const {
  const std::uint32_t rounded = (channel(c, sums) + (1u << 11)) >> 12;
  return static_cast<std::int32_t>(rounded > 65280 ? 65280 : rounded);
}

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

}  // namespace arcspan
