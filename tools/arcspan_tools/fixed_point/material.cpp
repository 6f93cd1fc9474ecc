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

Surface with_material(Surface surface, const FileMaterial& material, const SurfaceChoice& chosen) {
  if (!chosen.colour && material.colour) {
    surface.colour = *material.colour;
    surface.ambient_colour = material.ambient_colour;
  } else if (!chosen.colour && material.texture != nullptr) {
    surface.colour = {1, 1, 1};
  }
  if (!chosen.specular && material.specular) surface.specular = *material.specular;
  if (!chosen.shininess && material.shininess) surface.shininess = *material.shininess;
  if (!chosen.colour) surface.emission = material.emission;
  if (material.unlit) {
    surface.ambient = 1;
    surface.diffuse = 0;
    surface.specular = 0;
    surface.ambient_colour.reset();
  }
  return surface;
}

Material to_fixed(const Surface& surface) {
  const auto shared = [](const Vec3& c, const Share& share) {
    return Vec3{c.x * share.rgb.x, c.y * share.rgb.y, c.z * share.rgb.z};
  };
  const Vec3 ambient = shared(surface.ambient_colour.value_or(surface.colour), surface.ambient);
  return {channels(ambient + surface.emission), channels(shared(surface.colour, surface.diffuse)),
          channels(surface.specular.rgb), surface.shininess, coefficient(surface.highlight_fade)};
}

Rgb8 to_rgb8(Vec3 colour) {
  const auto level = [](double c) {
    return static_cast<std::uint8_t>(rounded(std::clamp(c, 0.0, 1.0) * 255));
  };
  return {level(colour.x), level(colour.y), level(colour.z)};
}

}  // namespace arcspan::tools
