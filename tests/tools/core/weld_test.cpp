// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/mesh_data.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

using Triangle = std::array<RawMesh::Corner, 3>;

Triangle triangle(Vec3 a, Vec3 b, Vec3 c) { return {{{a, {}}, {b, {}}, {c, {}}}}; }

Vec3 normal_at(const MeshData& mesh, Vec3 position) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (mesh.positions[i] == position) return mesh.normals[i];
  }
  return {};
}

void check_close(Vec3 a, Vec3 b) {
  CHECK(a.x == Approx(b.x).margin(1e-12));
  CHECK(a.y == Approx(b.y).margin(1e-12));
  CHECK(a.z == Approx(b.z).margin(1e-12));
}

}  // namespace

TEST_CASE("normals are averaged by area over the faces of a position") {
  // Two faces share the edge (0,0,0)-(0,1,0): one in the plane z = 0 of area 1, one in x = 0 of area 1/2.
  RawMesh raw;
  raw.triangles.push_back(triangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}));
  raw.triangles.push_back(triangle({-0.0, 0, 0}, {0, 1, 0}, {0, 0, -1}));
  const MeshData mesh = weld(raw, "m");
  CHECK(mesh.positions.size() == 4);
  check_close(normal_at(mesh, {2, 0, 0}), {0, 0, 1});
  check_close(normal_at(mesh, {0, 0, -1}), {-1, 0, 0});
  check_close(normal_at(mesh, {0, 0, 0}), normalised({-1, 0, 2}));
  check_close(normal_at(mesh, {0, 1, 0}), normalised({-1, 0, 2}));
}

TEST_CASE("normals of the file are kept, at unit length, and split a position") {
  RawMesh raw;
  Triangle a = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Triangle b = triangle({0, 0, 0}, {0, 1, 0}, {-1, 0, 0});
  for (auto& corner : a) corner.normal = {0, 3, 4};
  for (auto& corner : b) corner.normal = {0, 0, 1};
  b[2].normal = {};
  raw.triangles = {a, b};
  const MeshData mesh = weld(raw, "m");
  CHECK(mesh.positions.size() == 6);
  check_close(mesh.normals[mesh.triangles[0][0]], {0, 0.6, 0.8});
  check_close(mesh.normals[mesh.triangles[1][0]], {0, 0, 1});
  check_close(mesh.normals[mesh.triangles[1][2]], {0, 0, 1});
}

TEST_CASE("faces without area are dropped and counted") {
  RawMesh raw;
  raw.triangles.push_back(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  raw.triangles.push_back(triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}));
  raw.triangles.push_back(triangle({5, 5, 5}, {5, 5, 5}, {0, 1, 0}));
  const MeshData mesh = weld(raw, "m");
  CHECK(mesh.triangles.size() == 1);
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.dropped_faces == 2);
  raw.triangles.erase(raw.triangles.begin());
  CHECK(message_of<Failure>([&] { (void)weld(raw, "m"); }) == "m: no faces with an area (2 dropped)");
  CHECK(message_of<Failure>([] { (void)weld({}, "m"); }) == "m: no faces");
}

TEST_CASE("a sheet with two sides gets the first face's normal") {
  RawMesh raw;
  raw.triangles.push_back(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  raw.triangles.push_back(triangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}));
  for (const Vec3& n : weld(raw, "m").normals) check_close(n, {0, 0, 1});
}

TEST_CASE("the limits of a mesh are said") {
  RawMesh vertices;
  for (int i = 0; i < 22'000; ++i) {
    vertices.triangles.push_back(triangle({0.0, 0, 1.0 * i}, {1, 0, 1.0 * i}, {0, 1, 1.0 * i}));
  }
  CHECK(message_of<Failure>([&] { (void)weld(vertices, "m"); }) ==
        "m: too many vertices (more than 65536, the limit)");
  RawModel moving{vertices, {{}}, std::vector<std::uint32_t>(vertices.triangles.size())};
  CHECK(weld_parts(moving, "m").vertex_count() == 66'000);
  for (auto& corners : moving.mesh.triangles) corners[0].source = 0;
  CHECK(message_of<Failure>([&] { (void)weld_parts(moving, "m"); }) ==
        "m: too many vertices (more than 65536, the limit)");
  RawMesh faces;
  faces.triangles.assign(kMaxTriangles + 1, triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  CHECK(message_of<Failure>([&] { (void)weld(faces, "m"); }) ==
        "m: too many triangles (more than 1048576, the limit)");
}
