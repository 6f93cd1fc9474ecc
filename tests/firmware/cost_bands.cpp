// SPDX-License-Identifier: MIT
// The benchmark sphere by one method: drawn at once and in bands, with a vertex cache and without one. Each
// section includes clearing.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <new>
#include <span>

// The shading method, which CMakeLists.txt defines.
#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];

using Method = ARCSPAN_METHOD<scenes::Light>;

union ObjectMemory {
  Method::Lighting lighting;
  constexpr ObjectMemory() {}
};
[[gnu::section(".bss.frame")]] ObjectMemory object_memory;
[[gnu::section(".bss.frame")]] CachedVertex<Method> vertices[2048];
[[gnu::section(".bss.frame")]] TriangleRows triangle_rows[4096];

struct Scene {
  MeshView mesh;
  ClipTransform transform;
  const Method::Lighting* lighting = nullptr;
};

/// Clears and draws a picture in bands of `rows` rows.
template <class Cache>
bool draw_in_bands(const Scene& scene, std::int32_t rows, Cache&& cache) {
  hal::Framebuffer<Rgb565> band(colours, kCostWidth, rows);
  DepthBuffer depth(depths, kCostWidth, rows);
  for (std::int32_t top = 0; top < kCostHeight; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({0, 0, 0});
    depth.clear();
    if (!ok(draw_mesh<Method>(scene.mesh, scene.transform, *scene.lighting, band, depth, cache).status)) {
      return false;
    }
  }
  return true;
}

template <class Cache>
bool measure(const char* name, const Scene& scene, std::int32_t rows, Cache&& cache) {
  arcspan_mark();
  const bool drawn = draw_in_bands(scene, rows, cache);
  arcspan_mark();
  bare::print_line("section: ", name);
  bare::print_line("section: between");
  return drawn;
}

}  // namespace

int main() {
  static scenes::StageSet stage;
  static SphereMemory memory;
  SphereMeshes meshes;
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage))) return 1;
  if (!make_sphere_meshes(32, 16, memory, meshes)) return 1;
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(stage.light);
  const Scene scene{meshes.planed, stage.transform, &lighting};
  const std::span<CachedVertex<Method>> cache(vertices);
  const std::span<CachedVertex<Method>> none;
  static BandCache<Method> kept(cache);
  static BandCache<Method> kept_with_rows(cache, triangle_rows);
  const bool ok = measure("whole, cache", scene, kCostHeight, cache) &&
                  measure("whole, no cache", scene, kCostHeight, none) &&
                  measure("bands, cache", scene, 24, cache) && measure("bands, no cache", scene, 24, none) &&
                  measure("bands, kept", scene, 24, kept) &&
                  measure("bands, kept with rows", scene, 24, kept_with_rows);
  return ok ? 0 : 1;
}
