// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <cmath>
#include <map>
#include <utility>

using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

MeshData made(const std::string& name) { return generate(parse_generated_mesh(name).value()); }

// Edges that are not walked exactly once in each direction.
std::size_t open_edges(const MeshData& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> walked;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++walked[{t[i], t[(i + 1) % 3]}];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : walked) {
    if (count != 1 || walked.count({edge.second, edge.first}) != 1) ++open;
  }
  return open;
}

double signed_volume(const MeshData& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  return sum;
}

}  // namespace

TEST_CASE("generated meshes are closed, face outwards and have unit normals") {
  const std::string name =
      GENERATE(as<std::string>{}, "sphere:3x2", "sphere:32x16", "torus:3x3", "torus:48x24");
  CAPTURE(name);
  const MeshData mesh = made(name);
  CHECK(open_edges(mesh) == 0);
  CHECK(signed_volume(mesh) > 0);
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  for (const Vec3& n : mesh.normals) CHECK(length(n) == Approx(1.0).margin(1e-12));
}

TEST_CASE("generated meshes have the volume of what they approximate") {
  const double pi = std::acos(-1.0);
  CHECK(signed_volume(made("sphere:128x64")) == Approx(4 * pi / 3).epsilon(0.005));
  CHECK(signed_volume(made("torus:128x64")) == Approx(2 * pi * pi * 0.4 * 0.4).epsilon(0.005));
  CHECK(made("sphere:32x16").positions.size() == 32 * 15 + 2);
  CHECK(made("sphere:32x16").triangles.size() == 32 * 15 * 2);
  CHECK(made("torus:48x24").triangles.size() == 48 * 24 * 2);
}

TEST_CASE("texture points of generated meshes say where a corner lies around the axis, and on its ring") {
  const double turn = 2 * std::acos(-1.0);
  const bool is_torus = GENERATE(true, false);
  const std::string name = is_torus ? "torus:5x4" : "sphere:5x4";
  const RawModel raw = generate_with_texture_points(parse_generated_mesh(name).value());
  for (const auto& corners : raw.mesh.triangles) {
    for (const RawMesh::Corner& corner : corners) {
      const Uv at = corner.texture_point.value();
      const double angle = is_torus ? (0.5 - at.v) * turn : (0.5 - at.v) * turn / 2;
      const double from_axis = is_torus ? 1 + 0.4 * std::cos(angle) : std::cos(angle);
      const Vec3 there{from_axis * std::sin((at.u - 0.5) * turn), (is_torus ? 0.4 : 1) * std::sin(angle),
                       from_axis * std::cos((at.u - 0.5) * turn)};
      CHECK(length(there - corner.position) < 1e-9);
    }
  }
}

TEST_CASE("names that are not generated meshes are left alone, wrong ones refused") {
  CHECK_FALSE(parse_generated_mesh("sphere.obj").has_value());
  CHECK_FALSE(parse_generated_mesh("cube:3x3").has_value());
  for (const char* wrong : {"sphere:", "sphere:32", "sphere:2x16", "sphere:32x1", "torus:3x2", "torus:axb"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_generated_mesh(wrong), Failure);
  }
  CHECK(message_of<Failure>([] { (void)parse_generated_mesh("torus:999999x999999"); }) ==
        "torus:999999x999999: too many vertices (999998000001; the limit is 65536)");
}
