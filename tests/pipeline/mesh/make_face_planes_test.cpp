// SPDX-License-Identifier: MIT
// The planes of a mesh's triangles against double precision.
#include <arcspan/mesh/make_face_planes.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

Vec3 to_vec3(const ObjectPosition& p) { return {double(p.x), double(p.y), double(p.z)}; }

/// A triangle's least altitude along its normal; nothing without an area.
struct Truth {
  Vec3 altitude;
  double offset = 0;
};

Truth truth_of(const MeshView& mesh, std::size_t i) {
  const TriangleIndices t = mesh.triangle(i);
  const Vec3 a = to_vec3(mesh.position(t.a));
  const Vec3 b = to_vec3(mesh.position(t.b));
  const Vec3 c = to_vec3(mesh.position(t.c));
  const double longest = std::max({length(b - a), length(c - a), length(c - b)});
  if (longest == 0) return {};
  const Vec3 altitude = (1 / longest) * cross(b - a, c - a);
  return {altitude, dot(altitude, a)};
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Checks all planes of a mesh, and that one bit more would not fit a byte.
void check_planes(const MeshView& mesh) {
  std::vector<FacePlane> planes(mesh.triangle_count());
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(mesh, planes, scale)));
  double most_normal = 0;
  double most_offset = 0;
  double worst_normal = 0;
  double worst_offset = 0;  // beside what 32768 units make of a rounded normal
  const double lever = std::ldexp(0.75, -scale.offset_bits);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Truth truth = truth_of(mesh, i);
    const FacePlane& plane = planes[i];
    const Vec3 normal = std::ldexp(1.0, scale.normal_bits) * truth.altitude;
    const double offset = std::ldexp(truth.offset, scale.normal_bits - scale.offset_bits);
    worst_normal =
        std::max(worst_normal, largest(normal - Vec3{double(plane.x), double(plane.y), double(plane.z)}));
    worst_offset = std::max(worst_offset, std::abs(offset - plane.offset) - lever);
    most_normal = std::max(most_normal, largest(normal));
    most_offset = std::max(most_offset, std::abs(offset));
  }
  CAPTURE(int{scale.normal_bits}, int{scale.offset_bits}, most_normal, most_offset);
  CHECK(worst_normal <= 0.51);
  CHECK(worst_offset <= 0.51);
  CHECK((most_normal > 63.4 || most_normal == 0 || scale.normal_bits == PlaneScale::kMostNormalBits));
  CHECK((most_offset > 63.4 || scale.offset_bits == 0));
  double reach = 0;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
    reach = std::max(reach, length(to_vec3(mesh.position(i))));
  CHECK(scale.radius >= reach);
  CHECK(scale.radius <= reach + 1);
}

TestMesh random_triangles(Random& random, int count, std::int32_t size) {
  TestMesh mesh;
  const auto coordinate = [&] { return double(random.integer(-size, size)); };
  for (int i = 0; i < 3 * count; ++i) (void)mesh.add({coordinate(), coordinate(), coordinate()}, {0, 0, 1});
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint16_t>(3 * i);
    mesh.triangle(first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2));
  }
  return mesh;
}

}  // namespace

TEST_CASE("planes are the triangles' normals times their altitudes, to half a byte's unit") {
  Random random(101);
  for (const std::int32_t size : {1, 2, 7, 100, 3000, 32767}) {
    for (int round = 0; round < 40; ++round) {
      CAPTURE(size, round);
      check_planes(random_triangles(random, random.integer(1, 40), size).view());
    }
  }
  check_planes(make_sphere(16, 32, 32000, 0, random).view());
}

TEST_CASE("planes of the largest and of no triangles fit") {
  TestMesh corners;
  for (const double z : {-32768.0, 32767.0}) {
    for (const double y : {-32768.0, 32767.0}) {
      for (const double x : {-32768.0, 32767.0}) (void)corners.add({x, y, z}, {0, 0, 1});
    }
  }
  for (std::uint16_t a = 0; a < 8; ++a) {
    for (std::uint16_t b = 0; b < 8; ++b) {
      for (std::uint16_t c = 0; c < 8; ++c) corners.triangle(a, b, c);
    }
  }
  check_planes(corners.view());

  TestMesh empty;
  for (const double x : {5.0, 5.0, 9.0}) (void)empty.add({x, x, x}, {0, 0, 1});
  empty.triangle(0, 1, 1);  // a point
  empty.triangle(0, 1, 2);  // a line
  std::array<FacePlane, 2> planes{{{1, 1, 1, 1}, {1, 1, 1, 1}}};
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(empty.view(), planes, scale)));
  CHECK(planes[0] == FacePlane{});
  CHECK(planes[1] == FacePlane{});
}

TEST_CASE("planes want memory for every triangle") {
  Random random(102);
  const TestMesh mesh = random_triangles(random, 4, 1000);
  std::array<FacePlane, 3> few{{{1, 2, 3, 4}, {}, {}}};
  PlaneScale scale{5, 6, 7};
  CHECK(make_face_planes(mesh.view(), few, scale) == Status::kBufferTooSmall);
  CHECK(few[0] == FacePlane{1, 2, 3, 4});
  CHECK(scale == PlaneScale{5, 6, 7});
}

TEST_CASE("a mesh view takes planes for all of its triangles only, and a scale within its range") {
  Random random(103);
  const TestMesh mesh = random_triangles(random, 4, 1000);
  MeshView view = mesh.view();
  const std::array<FacePlane, 4> planes{};
  CHECK(view.planes() == nullptr);
  CHECK(view.attach(std::span(planes).first(3), {0, 0, 65535}) == Status::kInvalidArgument);
  for (const PlaneScale& wrong : {PlaneScale{PlaneScale::kMostNormalBits + 1, 0, 65535},
                                  PlaneScale{PlaneScale::kLeastNormalBits - 1, 0, 65535},
                                  PlaneScale{0, PlaneScale::kMostOffsetBits + 1, 65535}}) {
    CHECK(view.attach(planes, wrong) == Status::kInvalidArgument);
  }
  CHECK(view.planes() == nullptr);
  std::uint16_t reach = 0;
  while (!ok(view.attach(planes, {-5, 14, reach}))) ++reach;
  double farthest = 0;
  for (std::size_t i = 0; i < view.vertex_count(); ++i) {
    farthest = std::max(farthest, length(to_vec3(view.position(i))));
  }
  CHECK(reach == std::ceil(farthest));
  CHECK(view.planes() == planes.data());
  CHECK(view.plane_scale() == PlaneScale{-5, 14, reach});
}
