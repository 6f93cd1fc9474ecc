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
  Turn turn{};                ///< about the sphere's own axis
  bool is_benchmark = false;  ///< the one of which every figure is published
};

/// Calls `measure(scene)` for spheres of three finenesses with three radii, and for three spheres of other
/// sizes. Returns false at the first call that does.
template <class Measure>
bool for_each_cost_scene(Measure measure) {
  using enum SphereFineness;
  struct Sphere {
    const char* name;
    SphereFineness fineness;
    std::int32_t radius;
  };
  constexpr Sphere kSpheres[] = {
      {"16x8", k16x8, 36},    {"16x8", k16x8, 72},    {"16x8", k16x8, 108},  {"32x16", k32x16, 36},
      {"32x16", k32x16, 72},  {"32x16", k32x16, 108}, {"64x32", k64x32, 36}, {"64x32", k64x32, 72},
      {"64x32", k64x32, 108}, {"8x4", k8x4, 110},  // coarser than 60 degrees, cut by the picture
      {"8x4", k8x4, 1400},                         // cut by the guard band
      {"16x8", k16x8, 12},                         // small and coarse
      {"64x32", k64x32, 20}                        // triangles of a pixel
  };
  for (const Sphere& sphere : kSpheres) {
    CostScene scene;
    scene.sphere = sphere.name;
    scene.radius = sphere.radius;
    scene.is_benchmark = sphere.fineness == k32x16 && sphere.radius == 72;
    if (!make_sphere_meshes(sphere.fineness, scene.meshes) || !measure(scene)) return false;
  }
  return true;
}

/// Calls `measure(scene)` for spheres of three finenesses with each of `count` random radii and turns.
/// Returns false at the first call that does.
template <class Measure>
bool for_each_random_scene(std::uint32_t count, Measure measure) {
  using enum SphereFineness;
  std::uint32_t state = 1;
  const auto random = [&state](std::uint32_t end) {
    state = state * 1664525u + 1013904223u;  // Numerical Recipes' generator
    return static_cast<std::uint32_t>((std::uint64_t{state} * end) >> 32);
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    CostScene scene;
    scene.radius = 8 + static_cast<std::int32_t>(random(101));
    scene.turn.raw = static_cast<std::uint16_t>(random(65536));
    for (const SphereFineness fineness : {k16x8, k32x16, k64x32}) {
      scene.sphere = fineness == k16x8 ? "16x8" : fineness == k32x16 ? "32x16" : "64x32";
      if (!make_sphere_meshes(fineness, scene.meshes) || !measure(scene)) return false;
    }
  }
  return true;
}

}  // namespace arcspan
