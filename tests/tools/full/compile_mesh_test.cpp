// SPDX-License-Identifier: MIT
// The mesh compiler: limits are met, nothing of the shape is lost, what is written is what was made.
#include <arcspan/mesh/mesh_binary.hpp>

#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/compile/mesh_figures.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/mesh/plain/subset.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <arcspan_tools/support/failure.hpp>
#include <catch2/catch.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace arcspan;
using namespace arcspan::tools;
using arcspan::test::message_of;

namespace {

MeshData made(const std::string& name) { return generate(parse_generated_mesh(name).value()); }

/// A compiled model of one mesh.
struct CompiledMesh : CompiledModel {
  explicit CompiledMesh(CompiledModel all) : CompiledModel(std::move(all)), mesh(model.meshes[0]) {}
  FixedMesh mesh;
};

CompiledModel compiled(const Model& model, const MeshLimits& limits) {
  const BytesOf bytes_of = [](const FixedModel& m) {
    return array_bytes(m.vertex_count(), m.triangle_count());
  };
  return compile_model(model, limits, bytes_of, "test", [](std::size_t) {});
}

CompiledMesh compiled(const MeshData& mesh, const MeshLimits& limits) {
  return CompiledMesh(compiled(to_model(mesh), limits));
}

double volume(const FixedMesh& mesh) {
  double sum = 0;
  const auto at = [&mesh](std::size_t i) {
    const ObjectPosition& p = mesh.positions[mesh.indices[i]];
    return Vec3{double(p.x), double(p.y), double(p.z)} * mesh.unit;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) sum += dot(at(i), cross(at(i + 1), at(i + 2))) / 6;
  return sum;
}

/// A triangle by what its corners are, beginning with the least.
using Corner = std::array<std::int16_t, 5>;
std::multiset<std::array<Corner, 3>> triangles_of(const FixedMesh& mesh) {
  std::multiset<std::array<Corner, 3>> all;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const ObjectPosition& p = mesh.positions[mesh.indices[i + k]];
      const PackedNormal& n = mesh.normals[mesh.indices[i + k]];
      corners[k] = {p.x, p.y, p.z, n.u, n.v};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

}  // namespace

TEST_CASE("without limits the same triangles come out in an order that caches like") {
  const FixedMesh before = to_fixed(made("torus:48x24"));
  const CompiledMesh after = compiled(made("torus:48x24"), {});
  CHECK(after.how == Simplification::kNone);
  CHECK(after.mesh.positions.size() == before.positions.size());
  CHECK(triangles_of(after.mesh) == triangles_of(before));
  CHECK(after.cache_misses < 0.75);
  CHECK(after.cache_misses < after.cache_misses_before);
  CHECK(after.mesh.indices[0] == 0);  // vertices lie in the order of their use
}

TEST_CASE("limits are met from below, closely") {
  const MeshData torus = made("torus:48x24");
  const std::size_t triangles = GENERATE(std::size_t{2000}, std::size_t{700}, std::size_t{60});
  CAPTURE(triangles);
  const CompiledMesh few = compiled(torus, {triangles, {}, {}});
  CHECK(few.how == Simplification::kWithNormals);
  CHECK(few.mesh.indices.size() / 3 <= triangles);
  CHECK(few.mesh.indices.size() / 3 + 3 >= triangles);
  const std::size_t bytes = 11 * triangles;
  const CompiledMesh small = compiled(torus, {{}, bytes, {}});
  const std::size_t taken = array_bytes(small.mesh.positions.size(), small.mesh.indices.size() / 3);
  CHECK(array_bytes(256, 1) == 2560 + 3);
  CHECK(array_bytes(257, 1) == 2570 + 6);
  CHECK(taken <= bytes);
  CHECK(100 * taken > 97 * bytes);
}

TEST_CASE("a simplified sphere keeps its volume") {
  const MeshData sphere = made("sphere:64x32");
  const double whole = volume(to_fixed(sphere));
  const CompiledMesh simple = compiled(sphere, {600, {}, {}});
  CHECK(volume(simple.mesh) == Approx(whole).epsilon(0.03));
  CHECK(simple.error > 0);
  CHECK(simple.error < 0.05);
}

TEST_CASE("pieces of a mesh have all of its triangles, in order, and no more vertices than allowed") {
  MeshData torus = made("torus:48x24");
  for (const Vec3& p : torus.positions) torus.texture_points.push_back({p.x, p.z});
  const std::size_t most = GENERATE(3u, 50u, 700u, 5000u);
  const std::vector<MeshData> pieces = in_pieces(torus, most);
  CHECK((pieces.size() == 1) == (most == 5000));
  std::size_t next = 0;
  for (const MeshData& piece : pieces) {
    CHECK(piece.positions.size() <= most);
    if (&piece != &pieces.back()) CHECK(piece.positions.size() + 3 > most);
    for (const auto& triangle : piece.triangles) {
      REQUIRE(next < torus.triangles.size());
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t mine = triangle[k];
        const std::uint32_t whole = torus.triangles[next][k];
        REQUIRE(piece.positions[mine] == torus.positions[whole]);
        REQUIRE(piece.normals[mine] == torus.normals[whole]);
        REQUIRE(piece.texture_points[mine] == torus.texture_points[whole]);
      }
      ++next;
    }
  }
  CHECK(next == torus.triangles.size());
}

TEST_CASE("a mesh of more vertices than indices reach becomes two, unless it is simplified first") {
  constexpr std::uint32_t kSide = 280;
  MeshData field;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      field.positions.push_back({double(x), std::sin(0.05 * x) * std::cos(0.07 * y) * 9, double(y)});
      field.normals.push_back({0, 1, 0});
      if (x == 0 || y == 0) continue;
      const std::uint32_t at = y * kSide + x;
      field.triangles.push_back({at, at - kSide, at - kSide - 1});
      field.triangles.push_back({at, at - kSide - 1, at - 1});
    }
  }
  const CompiledModel whole = compiled(to_model(field), {});
  REQUIRE(whole.model.meshes.size() == 2);
  CHECK(whole.model.looks.size() == 2);
  CHECK(whole.model.triangle_count() == field.triangles.size());
  for (const FixedMesh& mesh : whole.model.meshes) CHECK_NOTHROW(mesh.view("test"));
  const CompiledModel few = compiled(to_model(field), {1000, {}, {}});
  CHECK(few.model.meshes.size() == 1);
  CHECK(few.model.triangle_count() > 900);
}

TEST_CASE("a mesh whose every edge is a crease is simplified all the same") {
  const MeshData flat = with_crease(made("sphere:32x16"), 0, "flat");
  REQUIRE(flat.positions.size() > 1900);
  const CompiledMesh simple = compiled(flat, {200, {}, {}});
  CHECK(simple.how == Simplification::kByPosition);
  CHECK(simple.mesh.indices.size() / 3 <= 200);
  CHECK(volume(simple.mesh) == Approx(volume(to_fixed(flat))).epsilon(0.1));
}

TEST_CASE("many bodies that cannot lose an edge are clustered") {
  MeshData tetrahedra;
  for (int i = 0; i < 64; ++i) {
    const Vec3 at{double(i % 4), double(i / 4 % 4), double(i / 16)};
    const auto first = static_cast<std::uint32_t>(tetrahedra.positions.size());
    for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{0.5, 0, 0}, Vec3{0, 0.5, 0}, Vec3{0, 0, 0.5}}) {
      tetrahedra.positions.push_back(at + corner);
      tetrahedra.normals.push_back({0, 0, 1});
    }
    for (const auto& t : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {0u, 3u, 2u}, {1u, 2u, 3u}}) {
      tetrahedra.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  const CompiledMesh few = compiled(tetrahedra, {100, {}, {}});
  CHECK(few.mesh.indices.size() / 3 <= 100);
  CHECK(few.mesh.indices.size() / 3 > 20);
}

TEST_CASE("limits that cannot be met are said") {
  const auto message = [](const MeshLimits& limits) {
    return message_of<Failure>([&] { (void)compiled(made("torus:24x12"), limits); });
  };
  CHECK(message({{}, 20, {}}).starts_with("test: cannot be simplified to 20 bytes (no attempt came below "));
  CHECK(message({1, 20, {}})
            .starts_with("test: cannot be simplified to 1 triangles and 20 bytes (no attempt came below "));
}

TEST_CASE("what 16 bits make equal is joined, and triangles without area go") {
  FixedMesh mesh;
  mesh.positions = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {9, 0, 0}, {18, 0, 0}, {7, 7, 7}};
  mesh.normals.resize(6);
  mesh.normals[4] = {5, 5};
  mesh.indices = {0, 1, 2, 0, 3, 2, 0, 1, 4, 1, 3, 2};
  const FixedMesh compact = compacted(mesh);
  CHECK(compact.positions.size() == 3);
  CHECK(compact.indices == std::vector<std::uint16_t>{0, 1, 2, 0, 1, 2});
}

TEST_CASE("the widest angle and the triangles that will be split are counted") {
  FixedMesh mesh;
  mesh.positions = {{0, 0, -5}, {9, 0, 0}, {0, 9, 0}, {9, 9, 8}};
  mesh.normals = {pack_normal(0, 0, 1), pack_normal(0, 1, 1), pack_normal(1, 0, 2), pack_normal(1, 0, -1)};
  mesh.indices = {0, 1, 2, 1, 3, 2};
  const MeshFigures found = figures_of(mesh);
  CHECK(found.widest_angle_degrees == Approx(120).margin(0.02));
  CHECK(found.wide_triangles == 1);
  CHECK(found.bounds.low == ObjectPosition{0, 0, -5});
  CHECK(found.bounds.high == ObjectPosition{9, 9, 8});
}

TEST_CASE("the library reads the binary that was written") {
  const std::string name = GENERATE(as<std::string>{}, "sphere:3x2", "sphere:16x16", "sphere:64x32");
  const bool planes = GENERATE(false, true);
  FixedMesh mesh = ordered(to_fixed(made(name)));
  if (planes) mesh = with_planes(std::move(mesh), name);
  const std::string bytes = mesh_binary_file(mesh, figures_of(mesh));
  REQUIRE(bytes.size() ==
          mesh_bytes(CompiledOutput::kBinary, mesh.positions.size(), mesh.indices.size() / 3, planes));
  const std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
  MeshView view;
  MeshBounds bounds;
  REQUIRE(ok(view_mesh_binary(file, view, &bounds)));
  REQUIRE(view.vertex_count() == mesh.positions.size());
  REQUIRE(view.triangle_count() == mesh.indices.size() / 3);
  for (std::size_t i = 0; i < view.vertex_count(); ++i) {
    CHECK(view.position(i) == mesh.positions[i]);
    CHECK(view.normal(i) == mesh.normals[i]);
  }
  for (std::size_t i = 0; i < view.triangle_count(); ++i) {
    CHECK(view.triangle(i).a == mesh.indices[3 * i]);
    CHECK(view.triangle(i).c == mesh.indices[3 * i + 2]);
  }
  CHECK(bounds.high.y == 32767);
  REQUIRE((view.planes() != nullptr) == planes);
  if (!planes) return;
  CHECK(view.plane_scale() == mesh.plane_scale);
  CHECK(std::equal(mesh.planes.begin(), mesh.planes.end(), view.planes()));
}

TEST_CASE("names become identifiers") {
  CHECK(identifier("bunny") == "bunny");
  CHECK(identifier("Stanford bunny (low)") == "Stanford_bunny_low");
  CHECK(identifier("3d") == "mesh_3d");
  CHECK(identifier("class") == "mesh_class");
  CHECK(identifier("__a__b") == "a_b");
  CHECK(identifier("\xC3\xA4") == "mesh");
  CHECK(identifier("NULL") == "mesh_NULL");
  CHECK(is_identifier("a_1"));
  CHECK(is_identifier("INTRO_MAXI"));
  for (const char* wrong : {"", "1a", "a b", "a::b", "_a", "a__b", "while", "restrict", "arcspan", "std",
                            "NULL", "linux", "UINT16_MAX", "INT8_C"}) {
    CAPTURE(wrong);
    CHECK_FALSE(is_identifier(wrong));
  }
}
