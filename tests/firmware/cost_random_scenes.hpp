// SPDX-License-Identifier: MIT
#pragma once

#include <tests/firmware/cost_measure.hpp>
#include <tests/firmware/random_scene.hpp>

/// Where the emulator loads the scenes of scripts/lib/random_scenes.py; CMakeLists.txt gives the address. The
/// memory is zero otherwise.
extern "C" const arcspan::RandomScene arcspan_random_scenes[];

namespace arcspan {

inline bool random_scenes_loaded() { return arcspan_random_scenes[0].segments != 0; }

inline bool draw_random_scene(const RandomScene& scene, std::uint32_t number) {
  static SphereMemory memory;
  SphereMeshes meshes;
  static ClipTransform transform;
  static CostLight light;
  if (!make_sphere_meshes(scene.segments, scene.rings, memory, meshes) ||
      !ok(set_random_stage(scene, {kCostWidth, kCostHeight}, transform, light))) {
    return false;
  }
  return measure_draw("draw ", "random", number, meshes.planed, transform, make_cost_lighting(light));
}

inline bool draw_random_scenes() {
  for (std::uint32_t i = 0; arcspan_random_scenes[i].segments != 0; ++i) {
    if (!draw_random_scene(arcspan_random_scenes[i], i)) return false;
  }
  return true;
}

}  // namespace arcspan
