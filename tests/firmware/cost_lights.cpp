// SPDX-License-Identifier: MIT
// The benchmark frame in other light than its own: Blinn's highlight, or two lights; ARCSPAN_LIGHTS and
// ARCSPAN_HIGHLIGHT, which CMakeLists.txt defines, say which. Making the illumination and drawing are
// sections.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <array>
#include <new>
#include <span>

#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

using Light = Illumination<ARCSPAN_LIGHTS, ARCSPAN_HIGHLIGHT>;
using Method = ARCSPAN_METHOD<Light>;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[512];

union LightingMemory {
  Method::Lighting lighting;
  constexpr LightingMemory() {}
};
[[gnu::section(".bss.frame")]] LightingMemory lighting_memory;

/// One light of full strength, or two grey ones of 0.7 and 0.5.
Status make_light(Light& light) {
  const Rotation rotation = scenes::stage_rotation({});
  std::array<DirectionalLight, ARCSPAN_LIGHTS> lights{};
  lights[0].towards = rotation.to_object(normalised(5000, 6000, 6245));
  if constexpr (ARCSPAN_LIGHTS == 2) {
    lights[0].strength = Coefficient::of(0.7);
    lights[1] = {rotation.to_object(normalised(-6000, 2000, 7746)), Coefficient::of(0.5)};
  }
  return Light::make(scenes::stage_material(), lights, rotation.to_object(normalised(0, 0, 1)), light);
}

}  // namespace

int main() {
  static scenes::StageSet stage;
  static Light light;
  static SphereMemory memory;
  SphereMeshes meshes;
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, 72, {}, stage))) return 1;
  if (!make_sphere_meshes(32, 16, memory, meshes)) return 1;
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const Status made = make_light(light);
  new (&lighting_memory.lighting) Method::Lighting(light);
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(meshes.planed, stage.transform, lighting_memory.lighting, frame,
                                             depth, std::span(cache));
  arcspan_mark();
  bare::print_line("section: make");
  bare::print_line("section: draw");
  bare::print_line("section: between");
  return ok(made) && ok(drawn.status) ? 0 : 2;
}
