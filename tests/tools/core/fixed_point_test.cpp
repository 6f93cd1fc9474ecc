// SPDX-License-Identifier: MIT

#include <arcspan/vertex/raster_vertex.hpp>

#include <arcspan_tools/fixed_point/camera.hpp>
#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/turntable.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>

using namespace arcspan;
using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

MeshData triangle(Vec3 a, Vec3 b, Vec3 c) {
  MeshData mesh;
  mesh.positions = {a, b, c};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

FixedMesh sphere() { return to_fixed(generate({GeneratedMesh::Kind::kSphere, 24, 12})); }

struct ScreenBox {
  int left = 1 << 20;
  int right = -(1 << 20);
  int top = 1 << 20;
  int bottom = -(1 << 20);
};

// The box of all vertices on the screen in whole pixels; fails if one is behind the near plane.
ScreenBox screen_box(const FixedMesh& mesh, const ClipTransform& transform) {
  ScreenBox box;
  for (const ObjectPosition& p : mesh.positions) {
    const ClipPosition clip = transform(p);
    REQUIRE(outcode(clip, transform.w_range()) == kInside);
    const RasterPosition at = project(clip, transform);
    const int x = at.x / 16 + transform.viewport().width / 2;
    const int y = at.y / 16 + transform.viewport().height / 2;
    box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
  }
  return box;
}

}  // namespace

TEST_CASE("the largest extent fills 16 bits, the others keep their proportion") {
  const FixedMesh mesh = to_fixed(triangle({1, 10, 5}, {3, 10, 5}, {3, 11, 5}));
  CHECK(mesh.positions[0] == ObjectPosition{-32767, -16383, 0});
  CHECK(mesh.positions[1] == ObjectPosition{32767, -16383, 0});
  CHECK(mesh.positions[2] == ObjectPosition{32767, 16384, 0});
  CHECK(mesh.unit == Approx(2.0 / 65534));
  CHECK(mesh.centre == Vec3{2, 10.5, 5});
  CHECK(mesh.view("m").triangle_count() == 1);
}

TEST_CASE("tiny and huge meshes convert alike") {
  const double scale = GENERATE(1e-25, 1e-3, 1.0, 1e25);
  const FixedMesh mesh = to_fixed(triangle({0, 0, 0}, {scale, 0, 0}, {0, scale, 0}));
  CHECK(mesh.positions[1] == ObjectPosition{32767, -32767, 0});
  const Camera camera = place_camera({}, mesh, {320, 240});
  CHECK_NOTHROW(to_fixed(camera, mesh, {320, 240}));
}

TEST_CASE("packed normals keep their direction") {
  const MeshData data = generate({GeneratedMesh::Kind::kSphere, 24, 12});
  const FixedMesh mesh = to_fixed(data);
  for (std::size_t i = 0; i < data.normals.size(); ++i) {
    const Direction n = unpack_normal(mesh.normals[i]);
    const Vec3 unpacked = Vec3{double(n.x.raw()), double(n.y.raw()), double(n.z.raw())} * (1.0 / 32768);
    CHECK(length(unpacked - data.normals[i]) < 2e-4);
  }
}

TEST_CASE("the default camera has the whole mesh in view, near the edge of the picture") {
  const Size size = GENERATE(Size{320, 240}, Size{240, 320}, Size{64, 512}, Size{2048, 16}, Size{7, 7});
  const double fov = GENERATE(10.0, 40.0, 120.0);
  CAPTURE(size.width, size.height, fov);
  const FixedMesh mesh = sphere();
  CameraOptions options;
  options.fov_degrees = fov;
  const ScreenBox box = screen_box(mesh, to_fixed(place_camera(options, mesh, size), mesh, size).transform);
  CHECK(box.left >= 0);
  CHECK(box.right < size.width);
  CHECK(box.top >= 0);
  CHECK(box.bottom < size.height);
  const double filled =
      std::max(double(box.right - box.left + 2) / size.width, double(box.bottom - box.top + 2) / size.height);
  CHECK(filled > 0.75);
}

TEST_CASE("a picture too narrow for the usual field of view gets a wider one, unless it was given") {
  const Size size = GENERATE(Size{30, 2048}, Size{8, 2048}, Size{2, 1024});
  CAPTURE(size.width, size.height);
  const FixedMesh mesh = sphere();
  CameraOptions options;
  const Camera camera = place_camera(options, mesh, size);
  CHECK(camera.fov_degrees > 40);
  const ScreenBox box = screen_box(mesh, to_fixed(camera, mesh, size).transform);
  CHECK(box.left >= 0);
  CHECK(box.right < size.width);
  options.fov_given = true;
  const std::string narrow = message_of<Failure>([&] { (void)place_camera(options, mesh, size); });
  const std::string start = "--fov: too narrow for the whole mesh in " + std::to_string(size.width) + "x" +
                            std::to_string(size.height) + " pixels (40; the least is ";
  REQUIRE(narrow.starts_with(start));
  options.fov_degrees = std::stod(narrow.substr(start.size()));  // does
  CHECK_NOTHROW(place_camera(options, mesh, size));
  Scene scene;
  scene.size = size;
  for (std::size_t frame = 0; frame < 3; ++frame) {
    CHECK_NOTHROW(make_job(Turntable(scene, mesh, 3).scene(frame), mesh, "sphere"));
  }
}

TEST_CASE("a camera sees right-handed: x to the right, y up, nearer is larger") {
  const FixedMesh mesh = to_fixed(triangle({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}));
  const CameraOptions options{Vec3{0, 0, 10}, Vec3{0, 0, 0}, {0, 1, 0}, 40};
  const FixedCamera camera = to_fixed(place_camera(options, mesh, {200, 200}), mesh, {200, 200});
  const auto at = [&](std::size_t i) {
    return project(camera.transform(mesh.positions[i]), camera.transform);
  };
  const double pixels = 100 / std::tan(20 * std::acos(-1.0) / 180) / 10;
  CHECK(at(0).x / 16.0 == Approx(-pixels).margin(0.1));
  CHECK(at(0).y / 16.0 == Approx(pixels).margin(0.1));
  CHECK(at(2).x / 16.0 == Approx(pixels).margin(0.1));
  CHECK(at(2).y / 16.0 == Approx(-pixels).margin(0.1));
  CHECK(camera.to_eye == Direction{DirectionComponent{}, DirectionComponent{}, DirectionComponent::of(1.0)});
}

TEST_CASE("an eye as far away as allowed has the whole mesh between its planes") {
  const FixedMesh mesh = sphere();
  const FixedCamera camera = to_fixed(Camera{{0, 0, 127.9}, {}, {0, 1, 0}, 2}, mesh, {64, 64});
  for (const ObjectPosition& p : mesh.positions) {
    REQUIRE(outcode(camera.transform(p), camera.transform.w_range()) == kInside);
  }
}

TEST_CASE("cameras that see nothing sensible are refused or put right") {
  const FixedMesh mesh = sphere();
  const Size size{64, 64};
  const auto message = [&](const CameraOptions& options) {
    return message_of<Failure>([&] { (void)to_fixed(place_camera(options, mesh, size), mesh, size); });
  };
  CHECK(message({Vec3{1, 2, 3}, Vec3{1, 2, 3}, {0, 1, 0}, 40}) == "--eye: is where the target is");
  CHECK(message({Vec3{0, 0, 5000}, {}, {0, 1, 0}, 40}) ==
        "--eye: too far away (5000; the limit is 64 times the size of the mesh)");
  CHECK(message({Vec3{1e308, 0, 0}, {}, {0, 1, 0}, 40}) ==
        "--eye: too far away (1e+308; the limit is 64 times the size of the mesh)");
  CHECK(message({Vec3{1e308, -1e308, 1e308}, {}, {0, 1, 0}, 40}).find("--eye: too far away (") == 0);
  CHECK(message({{}, Vec3{-1e308, 0, 0}, {0, 1, 0}, 40}) ==
        "--target: too far away (1e+308; the limit is 64 times the size of the mesh)");
  CHECK(message({Vec3{0, 0, 5}, Vec3{0, 1e308, 1e308}, {0, 1, 0}, 40}) == "(nothing was thrown)");
  CHECK(message({Vec3{0, 0, 5}, {}, {1e308, 1e308, 0}, 40}) == "(nothing was thrown)");
  CHECK_NOTHROW(to_fixed(place_camera({Vec3{0, 9, 0}, {}, {0, 1, 0}, 40}, mesh, size), mesh, size));
  CHECK_NOTHROW(to_fixed(place_camera({Vec3{0, 0, 0.5}, {}, {0, 1, 0}, 40}, mesh, size), mesh, size));
  CHECK_NOTHROW(
      to_fixed(place_camera({Vec3{0, 0, 5}, Vec3{0, 0, 9}, {0, 1, 0}, 40}, mesh, size), mesh, size));
}

TEST_CASE("the largest and the smallest vectors have a direction") {
  CHECK(normalised({0, 1e308, 1e308}) == normalised({0, 1, 1}));
  CHECK(normalised({-1e-320, 0, 0}).x == Approx(-1));
  CHECK(normalised({0, 0, 0}) == Vec3{});
}

TEST_CASE("surfaces become coefficients") {
  const Material m = to_fixed(Surface{{1, 0.5, 0}, 0.25, 0.5, 1, 17});
  CHECK(m.ambient.r == Coefficient::of(0.25));
  CHECK(m.ambient.g == Coefficient::of(0.125));
  CHECK(m.diffuse.g == Coefficient::of(0.25));
  CHECK(m.diffuse.b == Coefficient::of(0.0));
  CHECK(m.specular.b == Coefficient::of(1.0));
  CHECK(m.shininess == 17);
  CHECK(to_rgb8({1, 0.5, 0}) == Rgb8{255, 128, 0});
}

TEST_CASE("numbers out of a format's range are not converted") {
  CHECK(to_fixed_point<Coefficient>(1.0) == Coefficient::of(1.0));
  CHECK_FALSE(to_fixed_point<RotationEntry>(2.0).has_value());
  CHECK_FALSE(to_fixed_point<ObjectLength>(std::nan("")).has_value());
  CHECK(to_fixed_point<ObjectLength>(-1.5) == ObjectLength::of(-1.5));
}
