// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>

#include <tests/firmware/cost_method.hpp>
#include <tests/firmware/cost_stage.hpp>

#include <span>

namespace arcspan {

[[gnu::section(".bss.frame")]] static TriangleRows cost_triangle_rows[TriangleRows::entries(4096)];

struct BandScene {
  MeshView mesh;
  ClipTransform transform;
  const CostMethod::Lighting* lighting = nullptr;
};

/// Clears and draws a picture in bands of `rows` rows, as a section.
template <class Cache>
bool measure_bands(const char* name, const BandScene& scene, std::int32_t rows, Cache&& cache) {
  hal::Framebuffer<Rgb565> band(cost_colours, kCostWidth, rows);
  DepthBuffer depth(cost_depths, kCostWidth, rows);
  bool drawn = true;
  arcspan_mark();
  for (std::int32_t top = 0; drawn && top < kCostHeight; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({0, 0, 0});
    depth.clear();
    drawn =
        ok(draw_mesh<CostMethod>(scene.mesh, scene.transform, *scene.lighting, band, depth, cache).status);
  }
  arcspan_mark();
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  return drawn;
}

/// Draws the benchmark frame at once and in bands, with a vertex cache and without one.
inline bool draw_in_cost_bands() {
  static scenes::StageSet stage;
  static SphereMemory memory;
  SphereMeshes meshes;
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage))) return false;
  if (!make_sphere_meshes(32, 16, memory, meshes)) return false;
  const BandScene scene{meshes.planed, stage.transform, &make_cost_lighting(stage.light)};
  const std::span<CachedVertex<CostMethod>> cache(cost_cache);
  const std::span<CachedVertex<CostMethod>> none;
  static VertexCache<CostMethod> kept(cache);
  static VertexCache<CostMethod> kept_with_rows(cache, cost_triangle_rows);
  return measure_bands("whole, cache", scene, kCostHeight, cache) &&
         measure_bands("whole, no cache", scene, kCostHeight, none) &&
         measure_bands("bands, cache", scene, 24, cache) &&
         measure_bands("bands, no cache", scene, 24, none) && measure_bands("bands, kept", scene, 24, kept) &&
         measure_bands("bands, kept with rows", scene, 24, kept_with_rows);
}

}  // namespace arcspan
