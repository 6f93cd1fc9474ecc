// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination_features.hpp>
#include <arcspan/lighting/material.hpp>
#include <arcspan/numbers/fixed_formats.hpp>

#include <cstdint>

/// The checks of materials and lights, and the reasons for which constants of them do not compile.
namespace arcspan::detail {

inline constexpr std::int32_t kMostShininess = 256;

[[nodiscard]] constexpr bool in_unit_range(Coefficient c) {
  return c.raw() >= 0 && c <= Coefficient::of(1.0);
}

[[nodiscard]] constexpr bool in_unit_range(const ChannelCoefficients& c) {
  return in_unit_range(c.r) && in_unit_range(c.g) && in_unit_range(c.b);
}

[[nodiscard]] constexpr bool in_range(const Material& material) {
  return in_unit_range(material.ambient) && in_unit_range(material.diffuse) &&
         in_unit_range(material.specular) && in_unit_range(material.highlight_fade) &&
         material.shininess >= 1 && material.shininess <= kMostShininess;
}

[[nodiscard]] constexpr bool is_grey(const ChannelCoefficients& c) { return c.r == c.g && c.g == c.b; }

namespace refused {
void coefficient_outside_0_to_1();
void highlight_fade_outside_0_to_1();
void shininess_outside_1_to_256();
void light_strength_outside_0_to_1();
void light_colour_outside_0_to_1();
void features_lack_fading_highlights();
void features_lack_coloured_lights();
}  // namespace refused

/// Rejects a material that an illumination with `features` does not take.
constexpr void refuse_material(const Material& material, const IlluminationFeatures& features) {
  if (!in_unit_range(material.ambient) || !in_unit_range(material.diffuse) ||
      !in_unit_range(material.specular))
    refused::coefficient_outside_0_to_1();
  if (!in_unit_range(material.highlight_fade)) refused::highlight_fade_outside_0_to_1();
  if (!in_range(material)) refused::shininess_outside_1_to_256();
  if (!features.fading_highlights && material.highlight_fade.raw() != 0)
    refused::features_lack_fading_highlights();
}

/// Rejects a light whose strength or colour is out of range.
constexpr void refuse_light(Coefficient strength, const ChannelCoefficients& colour) {
  if (!in_unit_range(strength)) refused::light_strength_outside_0_to_1();
  if (!in_unit_range(colour)) refused::light_colour_outside_0_to_1();
}

}  // namespace arcspan::detail
