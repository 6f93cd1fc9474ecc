// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <catch2/catch.hpp>

#include <cmath>

using namespace arcspan::tools;

namespace {

/// The unit cube, 8 vertices, normals pointing away from its middle.
MeshData cube() {
  MeshData mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p{double(i & 1), double((i >> 1) & 1), double(i >> 2)};
    mesh.positions.push_back(p);
    mesh.normals.push_back(normalised(p - Vec3{0.5, 0.5, 0.5}));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

bool is_axis(Vec3 v) { return std::fabs(std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z) - 1) < 1e-12; }

}  // namespace

TEST_CASE("a cube is flat below its crease of 90 degrees and round above it") {
  const MeshData flat = with_crease(cube(), 89, "cube");
  CHECK(flat.positions.size() == 24);
  CHECK(flat.triangles.size() == 12);
  for (const Vec3& n : flat.normals) CHECK(is_axis(n));
  const MeshData round = with_crease(cube(), 91, "cube");
  CHECK(round.positions.size() == 8);
  for (const Vec3& n : round.normals) CHECK_FALSE(is_axis(n));
}

TEST_CASE("a file's open normals are averaged up to the crease, others are left alone") {
  const double degrees = GENERATE(20.0, 39.0, 41.0, 90.0);
  const double turn = degrees * kDegree;
  // Two triangles that meet at this angle along y.
  const Vec3 far{-std::cos(turn), 0, -std::sin(turn)};
  RawMesh mesh;
  mesh.triangles = {{{{{0, 0, 0}, {}}, {{1, 0, 0}, {}}, {{0, 1, 0}, {}}}},
                    {{{{0, 1, 0}, {}}, {far, {}}, {{0, 0, 0}, {}}}}};
  RawMesh smooth = mesh;
  CHECK_FALSE(add_creased_normals(smooth, kSmoothEverything));
  CHECK(smooth.triangles[0][0].normal == Vec3{});
  RawMesh grouped = mesh;
  grouped.smoothing = {RawMesh::kFlat, RawMesh::kSmooth + 1};
  CHECK_FALSE(add_creased_normals(grouped, kCreaseOfFiles));
  CHECK(add_creased_normals(mesh, kCreaseOfFiles));
  const Vec3 own = normalised(Vec3{0, 0, 1});
  CHECK(length(mesh.triangles[0][1].normal - own) < 1e-12);
  CHECK((length(mesh.triangles[0][0].normal - own) < 1e-12) == (degrees > 40));
  mesh.triangles[0][0].normal = {1, 0, 0};
  CHECK_FALSE(add_creased_normals(mesh, kCreaseOfFiles));
  CHECK(mesh.triangles[0][0].normal == Vec3{1, 0, 0});
}

TEST_CASE("a crease of 0 shades every face with its own normal") {
  const MeshData sphere = generate(parse_generated_mesh("sphere:16x8").value());
  const MeshData flat = with_crease(sphere, 0, "sphere");
  REQUIRE(flat.triangles.size() == sphere.triangles.size());
  for (const auto& t : flat.triangles) {
    const Vec3 a = flat.positions[t[0]];
    const Vec3 face = normalised(cross(flat.positions[t[1]] - a, flat.positions[t[2]] - a));
    for (const std::uint32_t i : t) CHECK(length(flat.normals[i] - face) < 1e-6);
  }
}

TEST_CASE("a crease of 180 gives a sphere its normals, nearly, and no vertex more") {
  const MeshData sphere = generate(parse_generated_mesh("sphere:64x32").value());
  const MeshData smooth = with_crease(sphere, 180, "sphere");
  CHECK(smooth.positions.size() == sphere.positions.size());
  for (std::size_t i = 0; i < smooth.positions.size(); ++i) {
    CHECK(length(smooth.normals[i] - smooth.positions[i]) < 0.02);
  }
}
