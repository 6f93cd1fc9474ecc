// SPDX-License-Identifier: MIT
// Every path of Arc draws meshes without undefined behaviour: one to four lights, grey and coloured, both
// models, both sides of faces, cut by the near plane and the guard band, and an environment map.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <tuple>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Frame = hal::Framebuffer<Rgb565>;
constexpr IlluminationFeatures kColoured{.coloured_lights = true, .fading_highlights = true};

using Lits = std::tuple<Illumination<1, Highlight::kPhong>, Illumination<2, Highlight::kBlinn>,
                        Illumination<3, Highlight::kPhong>, Illumination<4, Highlight::kPhong, kColoured>>;

TestCamera random_camera(Random& random) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  // From inside of the mesh to far away.
  camera.translation = {random.real(-4000, 4000), random.real(-4000, 4000), -random.decades(500, 60000)};
  camera.focal = random.decades(60, 1000);
  return camera;
}

TestMesh random_mesh(Random& random) {
  switch (random.integer(0, 3)) {
    case 0:
      return make_smooth_cube(7000);
    case 1:
      return make_smooth_tetrahedron(6000);
    default:
      return make_sphere(random.integer(3, 12), random.integer(3, 16), 8000, random.real(0, 0.4), random);
  }
}

template <class Lit>
Lit random_light(Random& random) {
  const auto share = [&random] { return Coefficient::from_raw(random.integer(0, 32768)); };
  Material material{{share(), share(), share()}, {share(), share(), share()}, {share(), share(), share()}};
  material.shininess = static_cast<std::int32_t>(random.decades(1, 257));
  if constexpr (Lit::kFeatures.fading_highlights) material.highlight_fade = share();
  std::array<DirectionalLight, Lit::kLights> lights;
  for (DirectionalLight& light : lights) {
    light.towards = to_direction(random_unit(random));
    light.strength = share();
    const Coefficient grey = share();
    light.colour = {grey, grey, grey};
    if constexpr (Lit::kFeatures.coloured_lights) light.colour.g = share();
  }
  Lit lit;
  REQUIRE(ok(Lit::make(material, lights, to_direction(random_unit(random)), lit)));
  REQUIRE(ok(lit.set_tolerance(random.chance(0.3) ? 0 : random.integer(0, 64))));
  return lit;
}

/// Draws a mesh and returns the number of pixels that are not as they were.
template <class Lighting>
int draw(const TestMesh& mesh, const TestCamera& camera, const Lighting& lighting) {
  std::vector<Frame::Word> words(Frame::words(camera.width, camera.height), 0x0821);
  Frame frame(words, camera.width, camera.height);
  std::vector<std::uint16_t> depths(DepthBuffer::words(camera.width, camera.height));
  DepthBuffer depth(depths, camera.width, camera.height);
  depth.clear();
  CHECK(ok(draw_mesh<Arc<Lighting>>(mesh.view(), camera.transform(), lighting, frame, depth).status));
  int drawn = 0;
  for (const Frame::Word word : words) drawn += word == 0x0821 ? 0 : 1;
  return drawn;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Arc draws any mesh by any lights from anywhere", "", Lits) {
  Random random(1);
  int drawn = 0;
  for (int i = 0; i < share_of(200); ++i) {
    const TestMesh mesh = random_mesh(random);
    drawn += draw(mesh, random_camera(random), random_light<TestType>(random));
  }
  CHECK(drawn > 0);
}

TEST_CASE("Arc draws any mesh with an environment map from anywhere") {
  Random random(2);
  const std::vector<std::uint16_t> picture(64, 0xFFFF);
  Texture<DirectTexels<>> texture;
  REQUIRE(ok(Texture<DirectTexels<>>::make(picture, {3, 3, 1}, texture)));
  int drawn = 0;
  for (int i = 0; i < share_of(200); ++i) {
    const TestMesh mesh = random_mesh(random);
    drawn += draw(mesh, random_camera(random), EnvironmentMap<DirectTexels<>>(texture));
  }
  CHECK(drawn > 0);
}
