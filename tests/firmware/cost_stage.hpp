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

/// Calls `measure(scene)` for the benchmark's sphere and for four that are unlike it. Returns false at the
/// first call that does.
template <class Measure>
bool for_each_cost_scene(Measure measure) {
  struct Sphere {
    const char* name;
    std::uint32_t segments;
    std::int32_t radius;
  };
  constexpr Sphere kSpheres[] = {
      {"32x16", 32, 72},
      {"8x4", 8, 110},   // coarser than 60 degrees, cut by the picture
      {"8x4", 8, 1400},  // cut by the guard band
      {"16x8", 16, 12},  // small and coarse
      {"64x32", 64, 20}  // triangles of a pixel
  };
  static SphereMemory memory;
  for (const Sphere& sphere : kSpheres) {
    CostScene scene;
    scene.sphere = sphere.name;
    scene.radius = sphere.radius;
    scene.is_benchmark = sphere.segments == 32 && sphere.radius == 72;
    if (!make_sphere_meshes(sphere.segments, sphere.segments / 2, memory, scene.meshes) || !measure(scene))
      return false;
  }
  return true;
}

}  // namespace arcspan
