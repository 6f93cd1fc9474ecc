// SPDX-License-Identifier: MIT
// The headline frame of docs/performance.md, drawn once by one of four methods, for
// scripts/frame-instructions, which counts what goes on inside counted_frame().
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/frames/stage_set.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

using namespace arcspan;

namespace {

constexpr std::int32_t kWidth = 320;
constexpr std::int32_t kHeight = 240;
constexpr std::int32_t kRadius = 72;
constexpr auto kSphere = scenes::make_sphere<32, 16>();
constexpr auto kPlanes = scenes::planes_of(kSphere);

std::uint16_t colours[kWidth * kHeight];
std::uint16_t depths[kWidth * kHeight];

template <class Method>
[[gnu::noinline]] DrawResult counted_frame(const MeshView& mesh, const ClipTransform& transform,
                                           const typename Method::Lighting& object,
                                           hal::Framebuffer<Rgb565>& frame, const DepthBuffer& depth,
                                           std::span<CachedVertex<Method>> cache) {
  return draw_mesh<Method>(mesh, transform, object, frame, depth, cache);
}

template <class Method>
int draw(std::int32_t tolerance = 0) {
  static CachedVertex<Method> cache[kSphere.positions.size()];
  MeshView mesh;
  scenes::StageSet stage;
  if (!ok(kSphere.view(mesh)) || !ok(kPlanes.attach_to(mesh)) ||
      !ok(scenes::set_stage({kWidth, kHeight}, kRadius, {}, stage)))
    return 1;
  typename Method::Lighting object(stage.light);
  if (!ok(object.set_tolerance(tolerance))) return 1;
  hal::Framebuffer<Rgb565> frame(colours, kWidth, kHeight);
  DepthBuffer depth(depths, kWidth, kHeight);
  depth.clear();
  const DrawResult drawn =
      counted_frame<Method>(mesh, stage.transform, object, frame, depth, std::span(cache));
  std::printf("%u triangles\n", static_cast<unsigned>(drawn.triangles));
  return ok(drawn.status) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view method = argc == 2 ? argv[1] : "";
  if (method == "flat") return draw<Flat<scenes::Light>>();
  if (method == "gouraud") return draw<Gouraud<scenes::Light>>();
  if (method == "arc-0") return draw<Arc<scenes::Light>>();
  if (method == "arc") return draw<Arc<scenes::Light>>(1);
  std::fputs("usage: headline_frame flat|gouraud|arc-0|arc\n", stderr);
  return EXIT_FAILURE;
}
