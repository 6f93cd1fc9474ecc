// SPDX-License-Identifier: MIT
#include <arcspan/draw.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/rgb888.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Frame = hal::Framebuffer<Rgb888>;

template <std::size_t Lights, Highlight Model>
std::vector<Frame::Word> picture(const TestMesh& mesh, const TestCamera& camera, std::int32_t tolerance) {
  using Light = Illumination<Lights, Model>;
  Light light = make_light<Lights, Model>(camera);
  REQUIRE(ok(light.set_tolerance(tolerance)));
  std::vector<Frame::Word> words(Frame::words(camera.width, camera.height));
  Frame frame(words, camera.width, camera.height);
  std::vector<std::uint16_t> depths(DepthBuffer::words(camera.width, camera.height));
  DepthBuffer depth(depths, camera.width, camera.height);
  depth.clear();
  REQUIRE(ok(draw_mesh<Arc<Light>>(mesh.view(), camera.transform(), light, frame, depth).status));
  return words;
}

/// The largest difference of a channel to the picture without tolerance.
template <std::size_t Lights, Highlight Model>
int most_off(const TestMesh& mesh, const TestCamera& camera, std::int32_t tolerance) {
  const std::vector<Frame::Word> exact = picture<Lights, Model>(mesh, camera, 0);
  const std::vector<Frame::Word> other = picture<Lights, Model>(mesh, camera, tolerance);
  int most = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Rgb8 a = Rgb888::decode(exact[i]);
    const Rgb8 b = Rgb888::decode(other[i]);
    most = std::max({most, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  }
  return most;
}

template <std::size_t Lights, Highlight Model>
void check(const TestMesh& mesh, const TestCamera& camera) {
  for (const std::int32_t tolerance : {1, 4, 16, 64}) {
    CAPTURE(tolerance);
    // Both pictures are rounded, and each is off by N·L and the highlight (docs/accuracy.md).
    CHECK(most_off<Lights, Model>(mesh, camera, tolerance) <= tolerance + 4);
  }
}

}  // namespace

TEST_CASE("a tolerance is 0...64, 0 at first; others are refused and change nothing") {
  using Light = Illumination<1, Highlight::kPhong>;
  Light light = make_light<1, Highlight::kPhong>(TestCamera{});
  CHECK(light.tolerance() == 0);
  CHECK(light.set_tolerance(64) == Status::kOk);
  CHECK(light.tolerance() == 64);
  CHECK(light.set_tolerance(5) == Status::kOk);
  for (const std::int32_t refused : {-1, 65, INT32_MIN, INT32_MAX}) {
    CHECK(light.set_tolerance(refused) == Status::kInvalidArgument);
    CHECK(light.tolerance() == 5);
  }
  CHECK(light.set_tolerance(0) == Status::kOk);
  CHECK(light.tolerance() == 0);
}

TEST_CASE("pictures of a sphere differ by the tolerance at most") {
  Random random(1);
  const TestMesh sphere = make_sphere(9, 14, 8000, 0, random);
  TestCamera camera;
  camera.translation = {0, 0, -22000};
  check<1, Highlight::kPhong>(sphere, camera);
  check<1, Highlight::kBlinn>(sphere, camera);
  check<3, Highlight::kPhong>(sphere, camera);
}

TEST_CASE("pictures of uneven meshes differ by the tolerance at most, from near by and from far") {
  Random random(2);
  for (int i = 0; i < share_of(20); ++i) {
    const TestMesh mesh = make_sphere(random.integer(3, 12), random.integer(4, 16), 8000, 0.2, random);
    TestCamera camera;
    camera.look_in_random_direction(random);
    camera.translation = {0, 0, -random.decades(11000, 60000)};
    CAPTURE(i);
    check<1, Highlight::kPhong>(mesh, camera);
  }
}
