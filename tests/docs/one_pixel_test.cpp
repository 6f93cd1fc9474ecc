// SPDX-License-Identifier: MIT
// A triangle by the specification of docs/one-pixel.md and by the library.
#include "specification.hpp"

#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <cstdlib>

using namespace arcspan;

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr ObjectPosition kCorners[] = {{-9000, -6000, 0}, {9000, -5000, 2000}, {1000, 7000, -1000}};
constexpr double kNormals[3][3] = {{-0.16, -0.12, 0.98}, {0.1, -0.02, 0.9948}, {0, 0.2, 0.9798}};
constexpr std::uint8_t kTriangle[] = {0, 1, 2};

std::uint8_t pixels[kWidth * kHeight];
std::uint16_t depths[kWidth * kHeight];

int main() {
  PackedNormal normals[3];
  std::array<specification::Vertex, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto scaled = [&](int axis) { return static_cast<std::int32_t>(kNormals[i][axis] * 30000); };
    normals[i] = pack_normal(scaled(0), scaled(1), scaled(2));
    const double length = std::hypot(kNormals[i][0], kNormals[i][1], kNormals[i][2]);
    corners[i] = {{double(kCorners[i].x), double(kCorners[i].y), kCorners[i].z - 30000.0},
                  {kNormals[i][0] / length, kNormals[i][1] / length, kNormals[i][2] / length}};
  }
  specification::Picture wanted{std::vector<std::uint16_t>(kWidth * kHeight, 65535),
                                std::vector<std::uint8_t>(kWidth * kHeight, 0)};
  specification::draw(corners, {60, 10000, 60000, kWidth, kHeight},
                      {{0.6, 0, 0.8}, {0, 0, 1}, 0.1, 0.5, 0.4, 16}, wanted);

  MeshView mesh;
  ClipTransform transform;
  const Placement ahead{Rotation::identity(), {{}, {}, ObjectLength::of(-30000)}};
  using Light = Illumination<1, Highlight::kPhong>;
  Light light;
  const auto grey = [](Coefficient c) { return decltype(Material::ambient){c, c, c}; };
  const Material material{grey(Coefficient::of(0.1)), grey(Coefficient::of(0.5)), grey(Coefficient::of(0.4)),
                          16};
  if (!ok(MeshView::make(kCorners, normals, std::span(kTriangle), mesh)) ||
      !ok(ClipTransform::make(ahead, {PixelLength::of(60), ObjectLength::of(10000), ObjectLength::of(60000)},
                              {kWidth, kHeight}, transform)) ||
      !ok(Light::make(material, {DirectionalLight{normalised(6, 0, 8)}}, normalised(0, 0, 1), light))) {
    return 1;
  }
  hal::Framebuffer<Gray8> frame(pixels, kWidth, kHeight);
  DepthBuffer depth(depths, kWidth, kHeight);
  frame.clear({0, 0, 0});
  depth.clear();
  if (!ok(draw_mesh<Arc<Light>>(mesh, transform, light, frame, depth).status)) return 1;

  int drawn = 0;
  for (std::size_t i = 0; i < kWidth * kHeight; ++i) {
    if ((depths[i] == 65535) != (wanted.depth[i] == 65535)) return 2;  // the same pixels
    if (std::abs(depths[i] - wanted.depth[i]) > 2 || std::abs(pixels[i] - wanted.grey[i]) > 3) return 3;
    drawn += depths[i] == 65535 ? 0 : 1;
  }
  return drawn > 300 ? 0 : 4;
}
