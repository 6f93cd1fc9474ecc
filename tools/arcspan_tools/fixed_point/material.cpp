// SPDX-License-Identifier: MIT
#include <arcspan_tools/fixed_point/camera.hpp>
#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/fixed_point/rounding.hpp>

#include <algorithm>

namespace arcspan::tools {
namespace {

Coefficient coefficient(double value) {
  return to_fixed_point<Coefficient>(std::clamp(value, 0.0, 1.0)).value();
}

ChannelCoefficients channels(Vec3 values) {
  return {coefficient(values.x), coefficient(values.y), coefficient(values.z)};
}

}  // namespace

DirectionalLight to_fixed(const SceneLight& light, double attenuation) {
  return {to_direction(light.towards), coefficient(1 / (light.distance + attenuation)),
          channels(light.colour)};
}

Material to_fixed(const Surface& surface) {
  const auto of_colour = [&surface](const Share& share) {
    const Vec3& c = surface.colour;
    return channels({c.x * share.rgb.x, c.y * share.rgb.y, c.z * share.rgb.z});
  };
  return {of_colour(surface.ambient), of_colour(surface.diffuse), channels(surface.specular.rgb),
          surface.shininess, coefficient(surface.highlight_fade)};
}

Rgb8 to_rgb8(Vec3 colour) {
  const auto level = [](double c) {
    return static_cast<std::uint8_t>(rounded(std::clamp(c, 0.0, 1.0) * 255));
  };
  return {level(colour.x), level(colour.y), level(colour.z)};
}

}  // namespace arcspan::tools
