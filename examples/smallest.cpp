// SPDX-License-Identifier: MIT
// The firmware with the least flash and RAM: the compiler computes mesh, camera and light, and the features
// of draw_mesh that this scene does not need are left out. Draws 32x32 pixels of 5-6-5 with depth, on any
// board of platform/.
#include <arcspan/bare/console.hpp>
#include <arcspan/bare/stack.hpp>
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <tests/frames/integer_shapes.hpp>

using namespace arcspan;
using Light = Illumination<1, Highlight::kBlinn>;

constexpr std::int32_t kWidth = 32;
constexpr std::int32_t kHeight = 32;
constexpr Coefficient kHalf = Coefficient::of(0.5);
constexpr Rotation kTilt = Rotation::about_x({4551}) * Rotation::about_y({3000});

constexpr auto kShape = scenes::make_sphere<32, 16>();
constexpr MeshView kSphere = MeshView::of(kShape.positions, kShape.normals, kShape.indices);
constexpr ClipTransform kCamera = ClipTransform::of(
    {kTilt, {{}, {}, ObjectLength::of(-4 * scenes::kRadius)}},
    {PixelLength::of(56), ObjectLength::of(32768), ObjectLength::of(98304)}, {kWidth, kHeight});
constexpr Light kLight =
    Light::of({{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, 32},
              {{{kTilt.to_object(normalised(3, 4, 5))}}}, kTilt.to_object(normalised(0, 0, 1)));

using Screen = hal::Framebuffer<Rgb565>;

Screen::Word pixels[Screen::words(kWidth, kHeight)];
std::uint16_t depths[DepthBuffer::words(kWidth, kHeight)];
constinit Screen screen(pixels, kWidth, kHeight);
constinit DepthBuffer nearest(depths, kWidth, kHeight);

int main() {
  screen.clear({0, 0, 0});
  nearest.clear();
  // The whole sphere is in view, and its triangles are small.
  constexpr DrawFeatures kFeatures{.clips = false, .planes = false, .small_triangles = false};
  const DrawResult drawn = draw_mesh<Arc<Light>, kFeatures>(kSphere, kCamera, kLight, screen, nearest);

  bare::print_line("triangles: ", drawn.triangles, ", left out: ", drawn.left_out);
  bare::print_line("middle pixel: ", std::uint32_t{screen.pixel(kWidth / 2, kHeight / 2).r});
  bare::print_line("stack: ", bare::deepest_stack(), " of ", bare::stack_size(), " bytes");
  return ok(drawn.status) ? 0 : 1;
}
