// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>

/// The light of a pixel by several coloured lights. Channels are unrolled, because compilers would keep their
/// sums in memory instead of in registers.
namespace arcspan {

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <std::size_t I>
ARCSPAN_INLINE constexpr void Illumination<Lights, Model, Features>::add_coloured(
    const Scalars& scalars, ChannelLevels& diffuse, ChannelLevels& specular) const {
  const std::uint32_t light = clamped(scalars[I]);
  if (light != 0) {
    const std::int32_t at = closeness(scalars, I);
    add_diffuse<I, 0>(light, diffuse);
    if (at > 0) add_specular<I, 0>(fade()(highlights_.value(at) >> 16, scalars[I]), specular);
  }
  if constexpr (I + 1 < Lights) add_coloured<I + 1>(scalars, diffuse, specular);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <std::size_t I, std::size_t Channel>
ARCSPAN_INLINE constexpr void Illumination<Lights, Model, Features>::add_diffuse(std::uint32_t light,
                                                                                 ChannelLevels& sum) const {
  sum[Channel] += diffuse_[Channel] * ((light * weights_[I][Channel]) >> 15);
  if constexpr (Channel < 2) add_diffuse<I, Channel + 1>(light, sum);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <std::size_t I, std::size_t Channel>
ARCSPAN_INLINE constexpr void Illumination<Lights, Model, Features>::add_specular(std::uint32_t most,
                                                                                  ChannelLevels& sum) const {
  sum[Channel] += ((highlights_.channel(Channel, most) * weights_[I][Channel]) >> 15) << 12;
  if constexpr (Channel < 2) add_specular<I, Channel + 1>(most, sum);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
template <std::size_t I>
ARCSPAN_INLINE constexpr void Illumination<Lights, Model, Features>::add_channel_light(
    const Scalars& scalars, ChannelLevels& diffuse, ChannelLevels& highlight) const {
  const std::int32_t light = scalars[I].raw() >> 15;  // not clamped: the sum is
  if (light > 0) {
    add_products(static_cast<std::uint32_t>(light), this->tints[I], diffuse);
    const std::int32_t at = closeness(scalars, I);
    if (at > 0) add_products(fade()(highlights_.value(at) >> 16, scalars[I]), this->shines[I], highlight);
  }
  if constexpr (I + 1 < Lights) add_channel_light<I + 1>(scalars, diffuse, highlight);
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
ARCSPAN_INLINE constexpr auto Illumination<Lights, Model, Features>::channel_light(
    const Scalars& scalars) const -> ChannelLight requires(Lights > 1 && Features.coloured_lights) {
  // The sums stay below 2^31 as long as N·L of four lights is below 1.7; that of unit normals is at most 1.
  ChannelLevels sums = ambient_;
  ChannelLevels highlight{};
  add_channel_light<0>(scalars, sums, highlight);
  const auto factor = [&sums](std::size_t channel) {
    return clamped_unsigned<10, 18>(static_cast<std::int32_t>(sums[channel] + (std::uint32_t{1} << 19)));
  };
  ChannelLight result{{factor(0), factor(1), factor(2)}, 0};
  if ((highlight[0] | highlight[1] | highlight[2]) == 0) return result;
  const auto rounded = [&highlight](std::size_t channel) {
    return static_cast<std::int32_t>(highlight[channel] + (std::uint32_t{1} << 22));
  };
  result.shine = clamped_unsigned<5, 23>(rounded(0)) << 11 | clamped_unsigned<6, 23>(rounded(1)) << 22 |
                 clamped_unsigned<5, 23>(rounded(2));
  return result;
}

}  // namespace arcspan
