// SPDX-License-Identifier: MIT
// The project's measured scene (tests/frames/stage_set.hpp), 320x240, rgb565, 16-bit depth: spheres of three
// finenesses and three radii by one method. Clearing and drawing are sections of their own for
// instruction_count.py; a line "scene: ..." gives the amounts drawn in the section before it.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/mark.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>

#include <tests/firmware/cost_spheres.hpp>
#include <tests/frames/stage_set.hpp>

#include <new>

// The shading method, which CMakeLists.txt defines.
#include ARCSPAN_METHOD_HEADER

using namespace arcspan;

namespace {

constexpr std::int32_t kWidth = 320;
constexpr std::int32_t kHeight = 240;

[[gnu::section(".bss.frame")]] std::uint16_t colours[kWidth * kHeight];
[[gnu::section(".bss.frame")]] std::uint16_t depths[kWidth * kHeight];

/// Forwards to a framebuffer and counts what passes; for the counting pass, not for the measured one.
struct CountingSink {
  using Format = Rgb565;
  hal::Framebuffer<Rgb565>& frame;
  std::uint32_t spans = 0;
  std::uint32_t pixels = 0;

  [[nodiscard]] Rect bounds() const { return frame.bounds(); }
  [[nodiscard]] Rgb565::Cursor open(const Span& run) {
    ++spans;
    pixels += static_cast<std::uint32_t>(run.count);
    return frame.open(run);
  }
  [[nodiscard]] Status close(const Span& run) { return frame.close(run); }
};

using Method = ARCSPAN_METHOD<scenes::Light>;

/// The method's tables for one object; a frame's memory, as a reflection map has 16 KB of them. Not
/// initialised: the constructor is paid where it runs, outside the measured sections.
union ObjectMemory {
  Method::Lighting lighting;
  constexpr ObjectMemory() {}
};
[[gnu::section(".bss.frame")]] ObjectMemory object_memory;
[[gnu::section(".bss.frame")]] CachedVertex<Method> cache[2048];

bool measure(const char* shape, const SphereMeshes& meshes, std::int32_t radius) {
  scenes::StageSet stage;
  if (!ok(scenes::set_stage({kWidth, kHeight}, radius, {}, stage))) return false;
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(stage.light);
  hal::Framebuffer<Rgb565> frame(colours, kWidth, kHeight);
  DepthBuffer depth(depths, kWidth, kHeight);
  CountingSink counting{frame};
  depth.clear();
  const DrawResult counted =
      draw_mesh<Method>(meshes.plain, stage.transform, lighting, counting, depth, cache);

  depth.clear();
  arcspan_mark();
  const DrawResult plain = draw_mesh<Method>(meshes.plain, stage.transform, lighting, frame, depth, cache);
  arcspan_mark();
  frame.clear({0, 0, 0});
  depth.clear();
  arcspan_mark();
  const DrawResult drawn = draw_mesh<Method>(meshes.planed, stage.transform, lighting, frame, depth, cache);
  arcspan_mark();
  // Without triangles only the vertex stage runs.
  const DrawResult none = draw_mesh<Method>(meshes.vertices, stage.transform, lighting, frame, depth, cache);
  arcspan_mark();
  bare::print_line("section: plain ", shape, " ", static_cast<std::uint32_t>(radius));
  bare::print_line("section: clear ", shape, " ", static_cast<std::uint32_t>(radius));
  bare::print_line("section: draw ", shape, " ", static_cast<std::uint32_t>(radius));
  bare::print_line("section: vertices ", shape, " ", static_cast<std::uint32_t>(radius));
  bare::print_line("section: between");
  bare::print_line("scene: ", shape, " ", static_cast<std::uint32_t>(radius), " ",
                   meshes.plain.vertex_count(), " ", counted.triangles, " ", counting.spans, " ",
                   counting.pixels);
  return ok(none.status) && ok(counted.status) && ok(plain.status) && ok(drawn.status) &&
         drawn.triangles == counted.triangles && plain.triangles == counted.triangles;
}

bool measure_sphere(const char* name, SphereFineness fineness) {
  SphereMeshes meshes;
  if (!make_sphere_meshes(fineness, meshes)) return false;
  for (const std::int32_t radius : {36, 72, 108}) {
    if (!measure(name, meshes, radius)) return false;
  }
  return true;
}

}  // namespace

int main() {
  return measure_sphere("16x8", SphereFineness::k16x8) && measure_sphere("32x16", SphereFineness::k32x16) &&
                 measure_sphere("64x32", SphereFineness::k64x32)
             ? 0
             : 1;
}
