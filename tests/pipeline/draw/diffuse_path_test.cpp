// SPDX-License-Identifier: MIT
// Leaving the highlight's scalar out where no highlight is within reach must not change a pixel.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/arc/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <vector>

using namespace arcspan;

namespace {

constexpr std::int32_t kSize = 160;
constexpr std::int32_t kRadius = 16384;
// Small triangles carry N·L alone with a bit less, because it is for wider normals too.
constexpr DrawFeatures kFeatures{.clips = false, .planes = false, .small_triangles = false};

/// Never leaves a scalar out.
template <Highlight Model>
struct Cautious : Illumination<1, Model> {
  using Scalars = typename Illumination<1, Model>::Scalars;
  [[nodiscard]] constexpr bool may_shine(const Scalars&, const Scalars&, const Scalars&, Cosine) const {
    return true;
  }
};

template <class Light>
std::vector<std::uint16_t> picture(const MeshView& mesh, std::int32_t shininess, const Direction& towards) {
  Placement placement{Rotation::about_x({4551}) * Rotation::about_y({3000}), {}};
  placement.translation[2] = ObjectLength::of(-4 * kRadius);
  ClipTransform transform;
  REQUIRE(ok(ClipTransform::make(placement,
                                 {PixelLength::of(280), ObjectLength::of(32768), ObjectLength::of(98304)},
                                 {kSize, kSize}, transform)));
  constexpr Coefficient kHalf = Coefficient::of(0.5);
  const Material material{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, shininess};
  Light light;
  REQUIRE(ok(Light::make(material, {DirectionalLight{placement.rotation.to_object(towards)}},
                         placement.rotation.to_object(normalised(0, 0, 1)), light)));
  std::vector<std::uint16_t> memory(hal::Framebuffer<Rgb565>::words(kSize, kSize));
  hal::Framebuffer<Rgb565> frame(memory, kSize, kSize);
  frame.clear({0, 0, 0});
  const DrawResult result = draw_mesh<Arc<Light>, kFeatures>(mesh, transform, light, frame, NoDepth{});
  REQUIRE(ok(result.status));
  REQUIRE(result.left_out == 0);
  return memory;
}

/// Draws a sphere so fine that its triangles are quadratic patches even with sharp highlights.
template <Highlight Model>
int pictures_that_differ() {
  test::Random random(3);
  const test::TestMesh sphere = test::make_sphere(32, 64, kRadius, 0, random);
  const MeshView mesh = sphere.view();
  int different = 0;
  for (const std::int32_t shininess : {1, 4, 16, 64, 256}) {
    for (const Direction& towards : {normalised(1, 2, 3), normalised(-3, 1, 0), normalised(1, 1, -2)}) {
      different += picture<Illumination<1, Model>>(mesh, shininess, towards) ==
                           picture<Cautious<Model>>(mesh, shininess, towards)
                       ? 0
                       : 1;
    }
  }
  return different;
}

}  // namespace

TEST_CASE("triangles out of the highlight's reach look the same without its scalar") {
  CHECK(pictures_that_differ<Highlight::kBlinn>() == 0);
  CHECK(pictures_that_differ<Highlight::kPhong>() == 0);
}
