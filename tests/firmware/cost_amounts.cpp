// SPDX-License-Identifier: MIT
// Counts what the measured scenes consist of, and prints a line for each: "scene: SPHERE RADIUS VERTICES
// TRIANGLES ROWS PIXELS", with visible triangles, their rows with pixels, and the pixels of these rows. The
// amounts are the same for every method. This is a program of its own, so that those that are measured draw
// into nothing but their framebuffer.
#include <arcspan/bare/console.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>

#include <tests/firmware/cost_stage.hpp>

#include <new>

using namespace arcspan;

namespace {

using Method = Flat<scenes::Light>;

struct CountingSink {
  using Format = Rgb565;

  [[nodiscard]] Rect bounds() const { return {0, 0, kCostWidth, kCostHeight}; }
  [[nodiscard]] Rgb565::Cursor open(const Span& run) {
    ++rows;
    pixels += static_cast<std::uint32_t>(run.count);
    return Rgb565::Cursor(row, run.x);
  }
  [[nodiscard]] Status close(const Span&) { return Status::kOk; }

  std::uint32_t rows = 0;
  std::uint32_t pixels = 0;
  Rgb565::Word row[kCostWidth] = {};
};

/// Static, because it is larger than the stack that programs are allowed.
union ObjectMemory {
  Method::Lighting lighting;
  constexpr ObjectMemory() {}
};
[[gnu::section(".bss.frame")]] ObjectMemory object_memory;

bool count(const CostScene& scene) {
  static scenes::StageSet stage;  // larger than the stack that programs are allowed
  if (!ok(scenes::set_stage({kCostWidth, kCostHeight}, scene.radius, {}, stage))) return false;
  const auto& lighting = *new (&object_memory.lighting) Method::Lighting(stage.light);
  CountingSink sink;
  const DrawResult drawn = draw_mesh<Method>(scene.meshes.planed, stage.transform, lighting, sink, NoDepth{});
  bare::print_line("scene: ", scene.sphere, " ", static_cast<std::uint32_t>(scene.radius), " ",
                   scene.meshes.planed.vertex_count(), " ", drawn.triangles, " ", sink.rows, " ",
                   sink.pixels);
  return ok(drawn.status);
}

}  // namespace

int main() { return for_each_cost_scene(count) ? 0 : 1; }
