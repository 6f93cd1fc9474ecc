// SPDX-License-Identifier: MIT
// The shortest complete firmware: draws a mesh in flash into one 128x64 frame of 16 grey levels, on any board
// of platform/.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/frames/integer_shapes.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;

constexpr auto kSphere = scenes::make_sphere<32, 16>();
constexpr Viewport kScreen{128, 64};
std::uint8_t frame_memory[hal::Framebuffer<Gray4>::words(128, 64)];

int main() {
  MeshView mesh;
  if (!ok(kSphere.view(mesh))) return 1;

  Placement placement{Rotation::about_x({4551}) * Rotation::about_y({3000}), {}};
  placement.translation[2] = ObjectLength::of(-4 * scenes::kRadius);
  ClipTransform transform;
  if (!ok(ClipTransform::make(placement,
                              {PixelLength::of(110), ObjectLength::of(32768), ObjectLength::of(98304)},
                              kScreen, transform))) {
    return 2;
  }

  constexpr Coefficient kHalf = Coefficient::of(0.5);
  const Material material{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, 32};
  const DirectionalLight sun{placement.rotation.to_object(normalised(3, 4, 5))};
  Light light;
  if (!ok(Light::make(material, {sun}, placement.rotation.to_object(normalised(0, 0, 1)), light))) return 3;

  hal::Framebuffer<Gray4> frame(frame_memory, kScreen.width, kScreen.height);
  frame.clear({0, 0, 0});
  const DrawResult drawn = draw_mesh<Arc<Light>>(mesh, transform, light, frame, NoDepth{});

  bare::print_line("triangles: ", drawn.triangles);
  bare::print_line("middle pixel: ", std::uint32_t{frame.pixel(64, 32).r});
  bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  return ok(drawn.status) ? 0 : 4;
}
