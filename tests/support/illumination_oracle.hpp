// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>

#include <tests/support/vec3.hpp>

#include <algorithm>
#include <array>

namespace arcspan::test {

/// A material and one light in double precision; S0 eq. 1 and 12.
struct IlluminationOracle {
  std::array<double, 3> ambient{};
  std::array<double, 3> diffuse{};
  std::array<double, 3> specular{};
  double shininess = 1;
  double strength = 1;

  using ChannelLevels = std::array<double, 3>;

  /// 0...255 before rounding. `cosine` is what the highlight is a power of, N·H or R·V; `lit` says whether
  /// the light reaches the surface, which is N·L > 0 but for rounding.
  [[nodiscard]] ChannelLevels levels(double normal_light, double cosine, bool lit) const {
    const double d = std::max(0.0, normal_light);
    const double s = lit ? std::pow(std::max(0.0, cosine), shininess) : 0;
    ChannelLevels result;
    for (std::size_t c = 0; c < 3; ++c) {
      result[c] = std::clamp(255 * (ambient[c] + strength * (diffuse[c] * d + specular[c] * s)), 0.0, 255.0);
    }
    return result;
  }
};

/// A random material with coefficients that 17.15 holds exactly; full ones included.
[[nodiscard]] inline Material random_material(Random& random, bool shiny, std::int32_t max_shininess) {
  const auto coefficient = [&random](double limit) {
    const double value = random.chance(0.1) ? limit : random.real(0, limit);
    return Coefficient::from_raw(static_cast<std::int32_t>(std::lround(value * 32768)));
  };
  const auto channels = [&](double limit) {
    return ChannelCoefficients{coefficient(limit), coefficient(limit), coefficient(limit)};
  };
  Material material;
  material.ambient = channels(0.3);
  material.diffuse = channels(1);
  if (shiny) material.specular = channels(1);
  material.shininess = random.integer(1, max_shininess);
  return material;
}

[[nodiscard]] inline IlluminationOracle to_oracle(const Material& material) {
  const auto channels = [](const ChannelCoefficients& c) {
    return std::array<double, 3>{c.r.raw() / 32768.0, c.g.raw() / 32768.0, c.b.raw() / 32768.0};
  };
  return {channels(material.ambient), channels(material.diffuse), channels(material.specular),
          static_cast<double>(material.shininess), 1};
}

}  // namespace arcspan::test
