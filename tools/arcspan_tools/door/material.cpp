// SPDX-License-Identifier: MIT
#include <arcspan_tools/door/material.hpp>
#include <arcspan_tools/door/rounding.hpp>

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

Material to_fixed(const Surface& surface) {
  const double s = surface.specular;
  return {channels(surface.colour * surface.ambient), channels(surface.colour * surface.diffuse),
          channels({s, s, s}), surface.shininess};
}

Rgb8 to_rgb8(Vec3 colour) {
  const auto level = [](double c) {
    return static_cast<std::uint8_t>(rounded(std::clamp(c, 0.0, 1.0) * 255));
  };
  return {level(colour.x), level(colour.y), level(colour.z)};
}

}  // namespace arcspan::tools
