// SPDX-License-Identifier: MIT
// One lit triangle, drawn by draw_mesh() with a vertex cache and a depth buffer, for scripts/house-size,
// which counts the lines that gcov finds executed by it. Compiled with --coverage.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#if __has_include(<arcspan/shading/surface/arc.hpp>)
#include <arcspan/shading/surface/arc.hpp>
#else  // e620102, the release before
#include <arcspan/shading/arc/arc.hpp>
#endif

#include <tests/frames/stage_set.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

extern "C" void __gcov_reset();
extern "C" void __gcov_dump();

using namespace arcspan;

namespace {

constexpr std::int32_t kSize = 128;
std::uint16_t colours[kSize * kSize];
std::uint16_t depths[kSize * kSize];

/// Draws a triangle of about `radius` pixels. Its normals lean away from the middle, by 2...6 to `ahead`.
/// Returns false unless it is drawn.
template <class Method>
bool draw(std::int32_t radius, std::int32_t ahead) {
  constexpr std::int16_t kReach = scenes::kRadius / 2;
  const ObjectPosition positions[] = {
      {-kReach, -kReach, 0}, {kReach, -kReach / 2, 0}, {-kReach / 4, kReach, 0}};
  const PackedNormal normals[] = {scenes::packed(-4, -4, ahead), scenes::packed(4, -2, ahead),
                                  scenes::packed(-1, 4, ahead)};
  const std::uint16_t indices[] = {0, 1, 2};
  MeshView mesh;
  scenes::StageSet stage;
  if (!ok(MeshView::make(positions, normals, indices, mesh)) ||
      !ok(scenes::set_stage({kSize, kSize}, radius, {}, stage)))
    return false;
  const typename Method::Lighting lighting(stage.light);
  hal::Framebuffer<Rgb565> frame(colours, kSize, kSize);
  DepthBuffer depth(depths, kSize, kSize);
  depth.clear();
  CachedVertex<Method> cache[3];
  const std::span vertices(cache);
  __gcov_reset();
  const DrawResult drawn = draw_mesh<Method>(mesh, stage.transform, lighting, frame, depth, vertices);
  __gcov_dump();
  return ok(drawn.status) && drawn.triangles == 1;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::int32_t kLarge = 60;
  constexpr std::int32_t kSmall = 8;
  constexpr std::int32_t kNear = 40;  // up to 12 degrees apart
  constexpr std::int32_t kWide = 4;   // up to 84 degrees apart
  const std::string_view name = argc == 2 ? argv[1] : "";
  bool drawn = false;
  if (name == "near") drawn = draw<Arc<scenes::Light>>(kLarge, kNear);
  if (name == "wide") drawn = draw<Arc<scenes::Light>>(kLarge, kWide);
  if (name == "small") drawn = draw<Arc<scenes::Light>>(kSmall, kNear);
  if (name == "flat") drawn = draw<Flat<scenes::Light>>(kLarge, kNear);
  if (!drawn) std::fputs("usage: one_triangle near|wide|small|flat\n", stderr);
  std::_Exit(drawn ? EXIT_SUCCESS : EXIT_FAILURE);  // the counters are not to be written again
}
