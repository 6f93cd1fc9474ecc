// SPDX-License-Identifier: MIT
// The measured scenes by one method, as a product draws them: the program has one call of draw_mesh(), for
// one method, one sink and one depth buffer, so that the compiler inlines as it does for a product. Set-up,
// clearing and drawing are sections of their own for instruction_count.py; "drawn:" gives the visible
// triangles, "stack:" the stack that the call used. If the emulator has loaded random scenes, these are drawn
// instead.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_stage.hpp>
#include <tests/firmware/random_scene.hpp>

#include <new>

// The shading method, which CMakeLists.txt defines.
#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

#ifdef ARCSPAN_COST_OWN_SINK
/// A sink that a product writes itself: the pipeline opens and closes every run. Not in an unnamed namespace:
/// frame_parts.py reads the full names of functions, and the compiler writes none for internal ones.
struct OwnSink {
  using Format = Rgb565;
  [[nodiscard]] Rect bounds() const { return {0, 0, kCostWidth, kCostHeight}; }
  [[nodiscard]] Rgb565::Cursor open(const Span& run) { return {colours + run.y * kCostWidth, run.x}; }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }
  std::uint16_t* colours;
};
#endif

namespace {

[[gnu::section(".bss.frame")]] std::uint16_t colours[kCostWidth * kCostHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kCostWidth * kCostHeight];

// Programs for another light than that of the measured scenes draw random scenes only.
#ifdef ARCSPAN_LIGHTS
using Light = Illumination<ARCSPAN_LIGHTS, ARCSPAN_HIGHLIGHT>;
#else
using Light = scenes::Light;
#endif
using Method = ARCSPAN_METHOD<Light>;

#ifdef ARCSPAN_COST_OWN_SINK
OwnSink make_sink() { return {colours}; }
#else
hal::Framebuffer<Rgb565> make_sink() { return {colours, kCostWidth, kCostHeight}; }
#endif

/// The method's tables for one object; a frame's memory, as a reflection map has 16 KB of them. Not
/// initialised: the constructor is paid where it runs, outside the measured sections.
union ObjectMemory {
  Method::Lighting lighting;
  constexpr ObjectMemory() {}
};
[[gnu::section(".bss.frame")]] ObjectMemory object_memory;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[2048];

/// Clears and draws, each in a section of its own, whose name ends with the sphere and the number.
bool measure_draw(const char* section, const char* sphere, std::uint32_t number, const MeshView& mesh,
                  const ClipTransform& transform, const Method::Lighting& lighting) {
  hal::Framebuffer<Rgb565> frame(colours, kCostWidth, kCostHeight);
  auto sink = make_sink();
  DepthBuffer depth(depths, kCostWidth, kCostHeight);
  bare::paint_stack();
  arcspan_mark();
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(mesh, transform, lighting, sink, depth, cache);
  arcspan_mark();
  const std::uint32_t depth_here = bare::stack_depth();
  bare::print_line("section: clear ", sphere, " ", number);
  bare::print_line("section: ", section, sphere, " ", number);
  bare::print_line("section: between");
  bare::print_line("stack: ", section, sphere, " ", number, " ", bare::deepest_stack() - depth_here);
  bare::print_line("drawn: ", section, sphere, " ", number, " ", drawn.triangles);
  return ok(drawn.status);
}

#ifdef ARCSPAN_LIGHTS
bool measure(const CostScene&) { return false; }
#else
bool measure(const CostScene& scene) {
  static scenes::StageSet stage;  // larger than the stack that programs are allowed
  arcspan_mark();
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, scene.radius, {}, stage))) return false;
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(stage.light);
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
#endif

/// Draws a random scene.
bool measure(const RandomScene& scene, std::uint32_t number) {
  static SphereMemory memory;
  SphereMeshes meshes;
  static ClipTransform transform;
  static Light light;
  if (!make_sphere_meshes(scene.segments, scene.rings, memory, meshes) ||
      !ok(set_random_stage(scene, {kCostWidth, kCostHeight}, transform, light))) {
    return false;
  }
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(light);
  return measure_draw("draw ", "random", number, meshes.planed, transform, lighting);
}

}  // namespace

/// Where the emulator loads the scenes of scripts/lib/random_scenes.py; CMakeLists.txt gives the address. The
/// memory is zero otherwise.
extern "C" const RandomScene arcspan_random_scenes[];

int main() {
  const RandomScene* const scenes = arcspan_random_scenes;
  if (scenes[0].segments == 0) {
    return for_each_cost_scene([](const CostScene& scene) { return measure(scene); }) ? 0 : 1;
  }
  for (std::uint32_t i = 0; scenes[i].segments != 0; ++i) {
    if (!measure(scenes[i], i)) return 2;
  }
  return 0;
}
