// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

namespace arcspan {

namespace detail {

[[nodiscard]] constexpr bool in_unit_range(Coefficient c) {
  return c.raw() >= 0 && c <= Coefficient::of(1.0);
}

[[nodiscard]] constexpr bool in_unit_range(const ChannelCoefficients& c) {
  return in_unit_range(c.r) && in_unit_range(c.g) && in_unit_range(c.b);
}

/// c * strength * 255, rounded: 8-bit steps with `bits` (0...24) fraction bits.
[[nodiscard]] constexpr std::uint32_t scaled_coefficient(Coefficient c, Coefficient strength, int bits) {
  const std::uint64_t product =
      std::uint64_t{static_cast<std::uint32_t>(c.raw())} * static_cast<std::uint32_t>(strength.raw()) * 255u;
  const int down = 2 * Coefficient::kFraction - bits;
  return static_cast<std::uint32_t>((product + (std::uint64_t{1} << (down - 1))) >> down);
}

/// scaled_coefficient() per channel.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> scaled_channels(const ChannelCoefficients& c,
                                                                     Coefficient strength, int bits) {
  return {scaled_coefficient(c.r, strength, bits), scaled_coefficient(c.g, strength, bits),
          scaled_coefficient(c.b, strength, bits)};
}

}  // namespace detail

template <std::size_t Lights, Highlight Model>
constexpr Status Illumination<Lights, Model>::make(const Material& material,
                                                   const std::array<DirectionalLight, Lights>& lights,
                                                   const Direction& to_eye, Illumination& illumination) {
  if (!detail::in_unit_range(material.ambient) || !detail::in_unit_range(material.diffuse) ||
      !detail::in_unit_range(material.specular) || material.shininess < 1 ||
      material.shininess > PowerTable::kMaxExponent) {
    return Status::kInvalidArgument;
  }
  for (const DirectionalLight& light : lights) {
    if (!detail::in_unit_range(light.strength)) return Status::kInvalidArgument;
  }
  // A single light's strength is multiplied into the coefficients. Several lights are weighted per pixel.
  const Coefficient strength = Lights == 1 ? lights[0].strength : Coefficient::of(1.0);
  constexpr int kCoefficientBits = 5;
  illumination.ambient_ = detail::scaled_channels(material.ambient, Coefficient::of(1.0), 20);
  illumination.diffuse_ = detail::scaled_channels(material.diffuse, strength, kCoefficientBits);
  illumination.specular_ = detail::scaled_channels(material.specular, strength, kCoefficientBits);
  for (std::size_t i = 0; i < Lights; ++i) {
    illumination.axes_[i] = lights[i].towards;
    illumination.strength_[i] = static_cast<std::uint32_t>(lights[i].strength.raw());
    illumination.half_one_plus_light_eye_[i] =
        (std::int32_t{1} << (Cosine::kFraction - 1)) + (dot(lights[i].towards, to_eye).raw() >> 1);
    if (Model == Highlight::kBlinn)
      illumination.axes_[(Lights + i) % kScalars] = half_way(lights[i].towards, to_eye);
  }
  if (Model == Highlight::kPhong) illumination.axes_[Lights] = to_eye;
  const std::array<std::uint32_t, 3>& specular = illumination.specular_;
  const bool white = specular[0] == specular[1] && specular[1] == specular[2];
  illumination.white_specular_ = white ? specular[0] : 0;
  illumination.widest_patch_ = arcspan::widest_patch(material.shininess);
  illumination.shininess_ = static_cast<std::uint32_t>(material.shininess);
  illumination.power_ = PowerTable(material.shininess);
  const std::uint32_t turns = Model == Highlight::kBlinn ? 1 : 2;
  illumination.most_curvature_ =
      static_cast<std::uint32_t>(Lights) *
      (illumination.most_diffuse() +
       illumination.most_specular() * static_cast<std::uint32_t>(material.shininess) * turns * turns);
  illumination.make_ramp();
  return Status::kOk;
}

template <std::size_t Lights, Highlight Model>
constexpr void Illumination<Lights, Model>::make_ramp() {
  for (std::size_t i = 0; i < ramp_.size(); ++i) {
    // Entry 0 is also the colour of the unlit side, where the diffuse part is 0.
    const std::uint32_t light = i == 0 ? 0 : static_cast<std::uint32_t>(i) * 128 + 64;
    // From 20 to 2 fraction bits, rounded, with half an 8-bit step added, as PackedRgb has it.
    const auto channel_level = [&](std::size_t c) {
      const std::uint32_t sum =
          (ambient_[c] + diffuse_[c] * light + (std::uint32_t{1} << 19) + (std::uint32_t{1} << 17)) >> 18;
      return sum > 1023 ? 1023u : sum;
    };
    ramp_[i] = PackedRgb::of(channel_level(0), channel_level(1), channel_level(2));
  }
}

}  // namespace arcspan
