// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/cost_stage.hpp>

#include <array>
#include <span>

namespace arcspan {

/// One light of full strength, or two grey ones of 0.7 and 0.5.
inline Status set_cost_light(CostLight& light) {
  const Rotation rotation = scenes::stage_rotation({});
  std::array<DirectionalLight, CostLight::kLights> lights{};
  lights[0].towards = rotation.to_object(normalised(5000, 6000, 6245));
  if constexpr (CostLight::kLights == 2) {
    lights[0].strength = Coefficient::of(0.7);
    lights[1] = {rotation.to_object(normalised(-6000, 2000, 7746)), Coefficient::of(0.5)};
  }
  return CostLight::make(scenes::stage_material(), lights, rotation.to_object(normalised(0, 0, 1)), light);
}

/// Draws the benchmark frame in the program's light. Making the illumination is a section too.
inline bool draw_in_cost_light() {
  static scenes::StageSet stage;
  static CostLight light;
  static SphereMemory memory;
  SphereMeshes meshes;
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage))) return false;
  if (!make_sphere_meshes(32, 16, memory, meshes)) return false;
  CostSink frame(cost_colours, kCostWidth, kCostHeight);
  DepthBuffer depth(cost_depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const Status made = set_cost_light(light);
  const auto& lighting = make_cost_lighting(light);
  arcspan_mark();
  const DrawResult drawn = draw_mesh<CostMethod>(meshes.planed, stage.transform, lighting, frame, depth,
                                                 std::span<CachedVertex<CostMethod>>(cost_cache));
  arcspan_mark();
  bare::print_line("section: make");
  bare::print_line("section: draw");
  bare::print_line("section: between");
  return ok(made) && ok(drawn.status);
}

}  // namespace arcspan
