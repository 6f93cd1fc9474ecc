// SPDX-License-Identifier: MIT
#pragma once

#include <tests/firmware/cost_spheres.hpp>
#include <tests/frames/stage_set.hpp>

namespace arcspan {

// The measured picture: 320x240 in rgb565 with 16-bit depth.
inline constexpr std::int32_t kCostWidth = 320;
inline constexpr std::int32_t kCostHeight = 240;

/// A measured scene: a sphere with a radius in pixels.
struct CostScene {
  const char* sphere = "";
  SphereMeshes meshes;
  std::int32_t radius = 0;
  bool is_benchmark = false;  ///< the one of which every figure is published
};

/// Calls `measure(scene)` for spheres of three finenesses with three radii. Returns false at the first call
/// that does.
template <class Measure>
bool for_each_cost_scene(Measure measure) {
  struct Sphere {
    const char* name;
    SphereFineness fineness;
  };
  constexpr Sphere kSpheres[] = {
      {"16x8", SphereFineness::k16x8}, {"32x16", SphereFineness::k32x16}, {"64x32", SphereFineness::k64x32}};
  for (const Sphere& sphere : kSpheres) {
    CostScene scene;
    scene.sphere = sphere.name;
    if (!make_sphere_meshes(sphere.fineness, scene.meshes)) return false;
    for (const std::int32_t radius : {36, 72, 108}) {
      scene.radius = radius;
      scene.is_benchmark = sphere.fineness == SphereFineness::k32x16 && radius == 72;
      if (!measure(scene)) return false;
    }
  }
  return true;
}

}  // namespace arcspan
