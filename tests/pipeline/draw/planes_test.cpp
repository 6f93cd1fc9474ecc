// SPDX-License-Identifier: MIT
// A picture of a mesh with planes is bit for bit the picture without.
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Frame = hal::Framebuffer<Rgb565>;

struct Picture {
  std::vector<Frame::Word> colours;
  std::vector<std::uint16_t> depths;
  std::uint32_t triangles = 0;

  friend bool operator==(const Picture&, const Picture&) = default;
};

template <class Method, DrawFeatures Features = DrawFeatures{}>
Picture drawn(const MeshView& mesh, const TestCamera& camera, const DrawOptions& options = {},
              bool cached = true) {
  const typename Method::Lighting lighting(make_light<1, Highlight::kPhong>(camera));
  Picture picture{std::vector<Frame::Word>(Frame::words(camera.width, camera.height)),
                  std::vector<std::uint16_t>(DepthBuffer::words(camera.width, camera.height))};
  Frame frame(picture.colours, camera.width, camera.height);
  DepthBuffer depth(picture.depths, camera.width, camera.height);
  frame.clear({1, 2, 3});
  depth.clear();
  std::vector<CachedVertex<Method>> cache(cached ? mesh.vertex_count() : 0);
  const DrawResult result = draw_mesh<Method, Features>(mesh, camera.transform(), lighting, frame, depth,
                                                        std::span(cache), options);
  REQUIRE(ok(result.status));
  picture.triangles = result.triangles;
  return picture;
}

/// A bumpy ball, whose folds hide and show each other.
TestMesh bumpy(Random& random) { return make_sphere(24, 40, 3000, random.real(0, 0.3), random); }

TestCamera random_camera(Random& random) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  camera.width = 200;
  camera.height = 160;
  camera.focal = std::round(random.decades(20, 400));
  // Some too near for planes to be used.
  camera.translation = {std::round(random.real(-3000, 3000)), std::round(random.real(-3000, 3000)),
                        -std::round(random.decades(4000, 30000))};
  return camera;
}

}  // namespace

TEMPLATE_TEST_CASE("planes change no pixel", "", Flat<Light>, Gouraud<Light>, Arc<Light>) {
  Random random(121);
  for (int round = 0; round < share_of(60); ++round) {
    const TestMesh mesh = bumpy(random);
    std::vector<FacePlane> planes(mesh.indices.size() / 3);
    PlaneScale scale;
    REQUIRE(ok(make_face_planes(mesh.view(), planes, scale)));
    MeshView with = mesh.view();
    REQUIRE(ok(with.attach(planes, scale)));
    const TestCamera camera = random_camera(random);
    CAPTURE(round, camera.focal);
    const Picture without = drawn<TestType>(mesh.view(), camera);
    CHECK(drawn<TestType>(with, camera) == without);
    CHECK(drawn<TestType>(with, camera, {}, false) == without);
    CHECK(drawn<TestType>(with, camera, {.two_sided = true}) ==
          drawn<TestType>(mesh.view(), camera, {.two_sided = true}));
  }
}

TEST_CASE("a back face found by its plane is drawn only if both sides are or planes are left out") {
  Random random(122);
  const TestMesh mesh = make_sphere(8, 12, 3000, 0, random);
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  // All say that they face away from the eye, by far.
  const Vec3 away = -127.0 * normalised(Vec3{} - camera.translation);
  const FacePlane back{static_cast<std::int8_t>(away.x), static_cast<std::int8_t>(away.y),
                       static_cast<std::int8_t>(away.z), 0};
  const std::vector<FacePlane> planes(mesh.indices.size() / 3, back);
  MeshView wrong = mesh.view();
  REQUIRE(ok(wrong.attach(planes, {-3, 14, 3001})));
  const Picture whole = drawn<Flat<Light>>(mesh.view(), camera);
  CHECK(whole.triangles > 0);
  CHECK(drawn<Flat<Light>>(wrong, camera).triangles == 0);
  CHECK(drawn<Flat<Light>>(wrong, camera, {}, false).triangles == 0);
  CHECK(drawn<Flat<Light>, DrawFeatures{.planes = false}>(wrong, camera) == whole);
  CHECK(drawn<Flat<Light>, DrawFeatures{.planes = false}>(wrong, camera, {}, false) == whole);
  CHECK(drawn<Flat<Light>>(wrong, camera, {.two_sided = true}) ==
        drawn<Flat<Light>>(mesh.view(), camera, {.two_sided = true}));
}
