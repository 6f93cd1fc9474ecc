// SPDX-License-Identifier: MIT
// What a firmware leaves out of draw_mesh changes no pixel of a scene that does not need it, and is told
// where one does.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/random.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
constexpr DrawFeatures kNone{.clips = false, .planes = false};

struct Picture {
  std::vector<std::uint16_t> colours;
  DrawResult result;

  [[nodiscard]] std::ptrdiff_t drawn() const {
    return std::count_if(colours.begin(), colours.end(), [](std::uint16_t code) { return code != 0; });
  }
};

/// With memory for a vertex cache.
template <class Method, DrawFeatures Features>
Picture drawn(const TestMesh& mesh, const TestCamera& camera, const DrawOptions& options = {}) {
  const typename Method::Lighting lighting(make_light<1, Highlight::kPhong>(camera));
  Picture picture;
  picture.colours.resize(hal::Framebuffer<Rgb565>::words(camera.width, camera.height));
  std::vector<std::uint16_t> depths(DepthBuffer::words(camera.width, camera.height), DepthBuffer::kFarthest);
  hal::Framebuffer<Rgb565> frame(picture.colours, camera.width, camera.height);
  const DepthBuffer depth(depths, camera.width, camera.height);
  std::vector<CachedVertex<Method>> cache(mesh.positions.size());
  picture.result =
      draw_mesh<Method, Features>(mesh.view(), camera.transform(), lighting, frame, depth, cache, options);
  return picture;
}

TestCamera camera_at(double distance) {
  TestCamera camera;
  camera.translation = {0, 0, -distance};
  return camera;
}

}  // namespace

TEMPLATE_TEST_CASE("a sphere in view needs no feature", "", Arc<Light>) {
  Random random(171);
  const TestMesh sphere = make_sphere(12, 16, 4000, 0.02, random);
  const Picture all = drawn<TestType, DrawFeatures{}>(sphere, camera_at(14000));
  const Picture none = drawn<TestType, kNone>(sphere, camera_at(14000));
  CHECK(none.result.status == Status::kOk);
  CHECK(none.result.left_out == 0);
  CHECK(none.result.triangles == all.result.triangles);
  CHECK(none.colours == all.colours);
  CHECK(none.drawn() > 5000);
}

TEST_CASE("triangles that the view cuts are left out and counted if nothing clips") {
  Random random(172);
  const TestMesh sphere = make_sphere(12, 16, 4000, 0.02, random);
  const TestCamera inside_near_plane = [] {
    TestCamera camera = camera_at(4600);
    camera.near_plane = 1000;
    camera.focal = 40;
    return camera;
  }();
  const Picture all = drawn<Arc<Light>, DrawFeatures{}>(sphere, inside_near_plane);
  const Picture none = drawn<Arc<Light>, kNone>(sphere, inside_near_plane);
  CHECK(all.result.left_out == 0);
  CHECK(all.drawn() > 0);
  CHECK(none.result.status == Status::kOk);
  CHECK(none.result.left_out > 0);
  CHECK(none.result.triangles < all.result.triangles);
}
