// SPDX-License-Identifier: MIT
// The cost of a figure of small triangles by one method, as cost_scenes.cpp measures spheres: 240x320 in
// rgb565 with 16-bit depth, turned by 30 degrees, without face planes, because a figure that moves has none.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_character.hpp>
#include <tests/frames/stage_set.hpp>

#include <cstdint>
#include <new>

// The shading method, which CMakeLists.txt defines.
#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

constexpr std::int32_t kWidth = 240;
constexpr std::int32_t kHeight = 320;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kWidth * kHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kWidth * kHeight];

using Method = ARCSPAN_METHOD<scenes::Light>;

union ObjectMemory {
  Method::Lighting lighting;
  constexpr ObjectMemory() {}
};
[[gnu::section(".bss.frame")]] ObjectMemory object_memory;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[kCharacterVertices];

}  // namespace

int main() {
  static scenes::StageSet stage;
  MeshView mesh;
  if (!ok(scenes::set_character_stage({kWidth, kHeight}, stage)) || !make_character_mesh(mesh)) return 1;
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(stage.light);
  hal::Framebuffer<Rgb565> frame(colours, kWidth, kHeight);
  DepthBuffer depth(depths, kWidth, kHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  bare::paint_stack();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(mesh, stage.transform, lighting, frame, depth, cache);
  arcspan_mark();
  const std::uint32_t depth_here = bare::stack_depth();
  bare::print_line("section: draw character");
  bare::print_line("section: between");
  bare::print_line("stack: draw character ", bare::deepest_stack() - depth_here);
  bare::print_line("drawn: draw character ", drawn.triangles);
  std::uint32_t lit = 0;
  std::uint32_t hash = 2166136261u;
  for (const std::uint16_t colour : colours) {
    lit += colour != 0 ? 1 : 0;
    hash = (hash ^ colour) * 16777619u;
  }
  bare::print_line("lit: ", lit, " hash: ", hash);
  return ok(drawn.status) ? 0 : 2;
}
