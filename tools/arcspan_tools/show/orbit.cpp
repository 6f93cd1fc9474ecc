// SPDX-License-Identifier: MIT
#include <arcspan_tools/show/orbit.hpp>

#include <cmath>

namespace arcspan::tools {
namespace {

// Rodrigues' formula: `v` turned about the unit vector `axis`.
Vec3 rotated(Vec3 v, Vec3 axis, double angle) {
  const double c = std::cos(angle);
  return v * c + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - c));
}

}  // namespace

Scene turned(const Scene& scene, const Camera& start, double angle) {
  const Vec3 axis = normalised(start.up);
  Scene result = scene;
  result.camera.eye = start.target + rotated(start.eye - start.target, axis, -angle);
  result.camera.target = start.target;
  for (SceneLight& light : result.lights) light.towards = rotated(light.towards, axis, -angle);
  return result;
}

}  // namespace arcspan::tools
