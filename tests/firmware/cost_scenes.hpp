// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

#include <tests/firmware/cost_measure.hpp>
#include <tests/firmware/cost_stage.hpp>

namespace arcspan {

/// Draws a measured scene. Set-up is a section too.
inline bool draw_cost_scene(const CostScene& scene) {
  static scenes::StageSet stage;  // larger than the stack that programs are allowed
  arcspan_mark();
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, scene.radius, {}, stage))) return false;
  const auto& lighting = make_cost_lighting(stage.light);
  arcspan_mark();
  bare::print_line("section: set-up ", scene.sphere, " ", static_cast<std::uint32_t>(scene.radius));
  bare::print_line("section: between");
  struct Section {
    const char* name;
    const MeshView& mesh;
  };
  // Without triangles only the vertex stage runs.
  const Section sections[] = {
      {"draw ", scene.meshes.planed}, {"plain ", scene.meshes.plain}, {"vertices ", scene.meshes.vertices}};
  for (const Section& section : sections) {
    const auto radius = static_cast<std::uint32_t>(scene.radius);
    if (!measure_draw(section.name, scene.sphere, radius, section.mesh, stage.transform, lighting))
      return false;
    if (!scene.is_benchmark) break;
  }
  return true;
}

}  // namespace arcspan
