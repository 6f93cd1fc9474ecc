// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

namespace detail {

/// A value per channel, 0...1 with 15 fraction bits.
using ChannelWeights = std::array<std::uint32_t, 3>;
inline constexpr ChannelWeights kFullWeights{32768, 32768, 32768};

/// The strength of a light times its colour, rounded.
[[nodiscard]] constexpr ChannelWeights channel_weights(const DirectionalLight& light) {
  const auto weight = [&light](Coefficient c) {
    return (static_cast<std::uint32_t>(light.strength.raw()) * static_cast<std::uint32_t>(c.raw()) +
            (1u << 14)) >>
           15;
  };
  return {weight(light.colour.r), weight(light.colour.g), weight(light.colour.b)};
}

/// c * weight * 255 per channel, rounded: 8-bit steps with `bits` (0...24) fraction bits.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> scaled_channels(const ChannelCoefficients& c,
                                                                     const ChannelWeights& weights,
                                                                     int bits) {
  const auto scaled = [down = 2 * Coefficient::kFraction - bits](Coefficient of, std::uint32_t weight) {
    const std::uint64_t product = std::uint64_t{static_cast<std::uint32_t>(of.raw())} * weight * 255u;
    return static_cast<std::uint32_t>((product + (std::uint64_t{1} << (down - 1))) >> down);
  };
  return {scaled(c.r, weights[0]), scaled(c.g, weights[1]), scaled(c.b, weights[2])};
}

}  // namespace detail

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr Status Illumination<Lights, Model, Features>::make(
    const Material& material, const std::array<DirectionalLight, Lights>& lights, const Direction& to_eye,
    Illumination& illumination) {
  static_assert(detail::kMostShininess == PowerTable::kMaxExponent);
  if (!detail::in_range(material)) return Status::kInvalidArgument;
  bool supported = Features.fading_highlights || material.highlight_fade.raw() == 0;
  for (const DirectionalLight& light : lights) {
    if (!detail::in_unit_range(light.strength) || !detail::in_unit_range(light.colour)) {
      return Status::kInvalidArgument;
    }
    supported = supported && (Lights == 1 || Features.coloured_lights || detail::is_grey(light.colour));
  }
  if (!supported) return Status::kUnsupported;
  ARCSPAN_CHECK(detail::is_unit(to_eye), "Illumination::make: to_eye is not a unit vector");
  for ([[maybe_unused]] const DirectionalLight& light : lights) {
    ARCSPAN_CHECK(light.strength.raw() == 0 || detail::is_unit(light.towards),
                  "Illumination::make: the direction to a light is not a unit vector");
  }
  static_cast<CheckedState&>(illumination).set(1);
  // A single light's weights are multiplied into the coefficients. Several lights are weighted per pixel.
  const detail::ChannelWeights weights =
      Lights == 1 ? detail::channel_weights(lights[0]) : detail::kFullWeights;
  illumination.ambient_ = detail::scaled_channels(material.ambient, detail::kFullWeights, 20);
  illumination.diffuse_ = detail::scaled_channels(material.diffuse, weights, 5);
  illumination.specular_ = detail::scaled_channels(material.specular, weights, 5);
  static_cast<FadeFor<Features>&>(illumination) = FadeFor<Features>(material.highlight_fade);
  const std::array<std::uint32_t, 3>& specular = illumination.specular_;
  const bool white = specular[0] == specular[1] && specular[1] == specular[2];
  illumination.white_specular_ = white ? specular[0] : 0;
  illumination.shininess_ = static_cast<std::uint32_t>(material.shininess);
  illumination.limits_.tolerance = 0;
  illumination.power_ = PowerTable(material.shininess);
  illumination.highlights_ = HighlightTable(illumination.power_, specular);
  std::array<Direction, Lights> to_lights;
  for (std::size_t i = 0; i < Lights; ++i) to_lights[i] = lights[i].towards;
  illumination.set_directions(to_lights, to_eye);
  if constexpr (kHasRamp) illumination.make_ramp();
  illumination.limits_.light_height = (illumination.most_diffuse() * illumination.ramp_range()) >> 15;
  if constexpr (Lights > 1) {
    illumination.set_strengths(lights);
  } else {
    illumination.set_limits(largest_channel(specular));
  }
  return Status::kOk;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr void Illumination<Lights, Model, Features>::set_directions(
    const std::array<Direction, Lights>& to_lights, const Direction& to_eye) {
  for (std::size_t i = 0; i < Lights; ++i) {
    axes_[i] = to_lights[i];
    // At c = 1 closeness is the reach: N·H / 2 = 1/2, or (N·L) (N·V) = (1 + L·V) / 2.
    Cosine at_peak = Cosine::of(0.5);
    if constexpr (Model == Highlight::kBlinn) {
      axes_[Lights + i] = half_way(to_lights[i], to_eye);
    } else {
      at_peak += Cosine::from_raw(dot(to_lights[i], to_eye).raw() >> 1);
      this->half_one_plus_light_eye[i] = at_peak.raw();
    }
    if (i < closeness_origin_.size())
      closeness_origin_[i] = wrap_sub(highlights_.reach(), highlights_.scaled(at_peak).raw());
  }
  if (Model == Highlight::kPhong) axes_[Lights] = to_eye;
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr void Illumination<Lights, Model, Features>::set_strengths(
    const std::array<DirectionalLight, Lights>& lights) requires(Lights > 1) {
  std::uint32_t strengths = 0;  // 15 fraction bits, at most 4
  for (std::size_t i = 0; i < Lights; ++i) {
    strengths += static_cast<std::uint32_t>(lights[i].strength.raw());
    const detail::ChannelWeights of_light = detail::channel_weights(lights[i]);
    if constexpr (!kHasRamp) {
      this->weights[i] = of_light;
      for (std::size_t c = 0; c < 3; ++c) {
        constexpr std::array<std::uint32_t, 3> kSteps{31, 63, 31};
        this->tints[i][c] = weighted(diffuse_[c], of_light[c]);
        this->shines[i][c] = highlights_.channel(c, of_light[c]) * kSteps[c] / 255;
      }
    } else {
      this->weights[i] = of_light[0];
      this->shares[i] = (of_light[0] * this->inverse) >> 15;
    }
  }
  set_limits(static_cast<std::uint32_t>((std::uint64_t{largest_channel(specular_)} * strengths) >> 15));
}

template <std::size_t Lights, Highlight Model, IlluminationFeatures Features>
constexpr void Illumination<Lights, Model, Features>::make_ramp() {
  if constexpr (Lights > 1) {
    // The light that saturates every channel, but at least three quarters of that of all lights at full
    // strength: diffuse_scalar() then stays below 4/3, for which quadratic surfaces have room.
    constexpr auto kMost = static_cast<std::uint32_t>(Lights) << 15;
    this->range = kMost / 4 * 3;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t missing = (255u << 5) - (ambient_[c] >> 15);  // 5 fraction bits
      if (diffuse_[c] * (this->range >> 5) < missing << 10) this->range = kMost;
    }
    this->inverse = (std::uint32_t{1} << 30) / this->range;
  }
  const std::array<std::uint32_t, 3> ambient = ambient_;  // copies, which need not be loaded for each entry
  const std::array<std::uint32_t, 3> diffuse = diffuse_;
  const std::uint32_t full = ramp_range();
  for (std::size_t i = 0; i < ramp_.size(); ++i) {
    // Entry 0 is also the colour of the unlit side, where the diffuse part is 0.
    const std::uint32_t middle = static_cast<std::uint32_t>(i) * 2 + 1;  // kRampBits + 1 fraction bits
    const std::uint32_t light = i == 0 ? 0 : (middle * full) >> (kRampBits + 1);
    // From 20 to 2 fraction bits, rounded, with half an 8-bit step added, as PackedRgb has it.
    constexpr std::uint32_t kHalves = (std::uint32_t{1} << 19) + (std::uint32_t{1} << 17);
    const auto level = [&](std::size_t c) { return ambient[c] + diffuse[c] * light; };
    ramp_[i] = packed_levels({level(0), level(1), level(2)}, kHalves);
  }
}

}  // namespace arcspan
