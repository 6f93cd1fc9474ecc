// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <catch2/catch.hpp>

#include <cmath>

using namespace arcspan::tools;

namespace {

FixedMesh made(const std::string& name) { return to_fixed(generate(parse_generated_mesh(name).value())); }

Image frame_of(const Turntable& turntable, const FixedMesh& mesh, std::size_t frame) {
  const RenderJob job = make_job(turntable.scene(frame), mesh, "test");
  return find_renderer("arc", "rgb888", false).render(job, [](std::size_t) {}).image;
}

}  // namespace

TEST_CASE("a turned mesh keeps its distance, its light and its height") {
  const FixedMesh mesh = made("torus:16x8");
  Scene scene;
  const Turntable turntable(scene, mesh, 8);
  const Scene first = turntable.scene(0);
  for (std::size_t frame = 1; frame < 8; ++frame) {
    const Scene turned = turntable.scene(frame);
    const Vec3 from = *first.camera.eye - *first.camera.target;
    const Vec3 now = *turned.camera.eye - *turned.camera.target;
    CHECK(length(now) == Approx(length(from)));
    CHECK(now.y == Approx(from.y));
    CHECK(dot(now, turned.lights[0].towards) == Approx(dot(from, first.lights[0].towards)));
    // An eighth of a turn a frame; from above, the camera goes clockwise, that is the mesh counter-clockwise.
    CHECK(std::atan2(from.z * now.x - from.x * now.z, from.x * now.x + from.z * now.z) ==
          Approx(-std::remainder(double(frame), 8.0) * std::acos(-1.0) / 4).margin(1e-9));
  }
}

TEST_CASE("a torus of 8 segments looks the same after every eighth of a turn, and not in between") {
  const FixedMesh mesh = made("torus:8x5");
  Scene scene;
  scene.size = {96, 72};
  const Turntable turntable(scene, mesh, 16);
  const Image first = frame_of(turntable, mesh, 0);
  const auto differing = [&first](const Image& other) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
      const auto far = [](int a, int b) { return std::abs(a - b) > 8; };
      const arcspan::Rgb8 a = first.pixels[i];
      const arcspan::Rgb8 b = other.pixels[i];
      count += far(a.r, b.r) || far(a.g, b.g) || far(a.b, b.b);
    }
    return count;
  };
  // Positions were rounded to 16 bits, so an outline may move by a sixteenth of a pixel.
  CHECK(differing(frame_of(turntable, mesh, 2)) < 40);
  CHECK(differing(frame_of(turntable, mesh, 6)) < 40);
  CHECK(differing(frame_of(turntable, mesh, 1)) > 200);
}

TEST_CASE("the mesh stays inside the picture all the way round") {
  FixedMesh mesh;  // a long thin triangle that is seen end-on at first
  mesh.positions = {{0, 0, 32767}, {0, 300, -32767}, {0, -300, -32767}};
  mesh.normals.resize(3);
  mesh.indices = {0, 1, 2};
  Scene scene;
  scene.size = {64, 64};
  scene.camera.view = {0, 0.2, 1};
  scene.two_sided = true;
  const Turntable turntable(scene, mesh, 12);
  for (std::size_t frame = 0; frame < 12; ++frame) {
    const Image image = frame_of(turntable, mesh, frame);
    for (std::int32_t i = 0; i < 64; ++i) {
      CHECK(image.at(i, 0) == image.at(0, 0));
      CHECK(image.at(0, i) == image.at(0, 0));
      CHECK(image.at(63, i) == image.at(0, 0));
    }
  }
}
