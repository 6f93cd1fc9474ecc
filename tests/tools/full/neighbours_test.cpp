// SPDX-License-Identifier: MIT
// Neighbours of triangles as `arcspan mesh --outlines` finds and writes them.
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/model/model_neighbours.hpp>

#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <arcspan_tools/mesh/plain/crease.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;

namespace {

MeshData made(const std::string& name) { return generate(parse_generated_mesh(name).value()); }

/// How many edges there are of each kind.
struct Counts {
  std::array<std::size_t, 4> of_kind{};

  [[nodiscard]] std::size_t operator[](EdgeKind kind) const {
    return of_kind[static_cast<std::size_t>(kind)];
  }
};

Counts counts(const FixedMesh& mesh, const std::vector<std::uint8_t>& bytes) {
  MeshNeighbours neighbours;
  REQUIRE(ok(MeshNeighbours::make(mesh.view("test"), bytes, neighbours)));
  Counts found;
  const std::uint8_t* at = bytes.data();
  for (std::size_t i = 0; i < neighbours.triangle_count(); ++i) {
    const std::uint8_t* const first = at;
    const unsigned kinds = *at++;
    std::ptrdiff_t distances = 0;
    for (unsigned edge = 0; edge < 3; ++edge) {
      const EdgeKind kind = arcspan::detail::edge_kind(kinds, edge);
      ++found.of_kind[static_cast<std::size_t>(kind)];
      if (!arcspan::detail::has_distance(kind)) continue;
      static_cast<void>(arcspan::detail::read_distance(at));
      ++distances;
    }
    const bool counted = arcspan::detail::has_ordinary_edges(kinds) && at - first == distances + 1;
    CHECK(arcspan::detail::short_distances(kinds) == (counted ? static_cast<unsigned>(distances) : 0));
  }
  return found;
}

/// A cube of 12 triangles with smooth normals.
MeshData cube() {
  MeshData mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0};
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normalised(corner));
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
      {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// A model of a mesh without a material.
FixedModel model_of(const FixedMesh& mesh) {
  FixedModel model;
  model.meshes.push_back(mesh);
  model.looks.emplace_back();
  return model;
}

}  // namespace

TEST_CASE("neighbours: a closed mesh has no borders, whatever seams its normals have") {
  const std::string name = GENERATE(as<std::string>{}, "sphere:32x16", "torus:48x24", "sphere:3x2");
  const FixedMesh mesh = ordered(to_fixed(made(name)));
  const std::size_t triangles = mesh.indices.size() / 3;
  const std::vector<std::uint8_t> bytes = neighbours_of(mesh);
  const Counts found = counts(mesh, bytes);
  CHECK(found[EdgeKind::kBorder] == 0);
  CHECK(found[EdgeKind::kCrease] == 0);
  CHECK(found[EdgeKind::kLater] == found[EdgeKind::kEarlier]);
  CHECK(2 * found[EdgeKind::kLater] == 3 * triangles);
  CHECK(2 * bytes.size() <= 7 * triangles);  // at most 3.5 bytes per triangle
}

TEST_CASE("neighbours: the edges of a cube are creases if it is flat, the diagonals of its faces are not") {
  const FixedMesh smooth = to_fixed(cube());
  const FixedMesh flat = to_fixed(with_crease(cube(), 30, "cube"));
  CHECK(counts(smooth, neighbours_of(smooth))[EdgeKind::kCrease] == 0);
  const Counts found = counts(flat, neighbours_of(flat));
  CHECK(found[EdgeKind::kCrease] == 12);
  CHECK(found[EdgeKind::kLater] == 6);
  CHECK(found[EdgeKind::kBorder] == 0);
  // Normals are 90 degrees apart.
  CHECK(counts(flat, neighbours_of(flat, 89))[EdgeKind::kCrease] == 12);
  CHECK(counts(flat, neighbours_of(flat, 91))[EdgeKind::kCrease] == 0);
}

TEST_CASE("neighbours: an edge whose sides have different colours is a crease") {
  FixedMesh mesh = to_fixed(with_crease(cube(), 30, "cube"));
  mesh.colours.assign(mesh.positions.size(), {10, 20, 30});
  CHECK(counts(mesh, neighbours_of(mesh, 91))[EdgeKind::kCrease] == 0);
  for (std::size_t i = 0; i < 3; ++i) mesh.colours[mesh.indices[i]] = {11, 20, 30};
  for (std::size_t i = 3; i < 6; ++i) mesh.colours[mesh.indices[i]] = {11, 20, 30};
  CHECK(counts(mesh, neighbours_of(mesh, 91))[EdgeKind::kCrease] == 4);
}

TEST_CASE("neighbours: what ends has borders, and so have triangles that run in the same direction") {
  FixedMesh mesh = to_fixed(cube());
  mesh.indices.resize(mesh.indices.size() - 6);  // one face is missing
  CHECK(counts(mesh, neighbours_of(mesh))[EdgeKind::kBorder] == 4);
  mesh.indices = {0, 1, 2, 0, 1, 3};
  CHECK(counts(mesh, neighbours_of(mesh))[EdgeKind::kBorder] == 6);
  mesh.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};  // of three at one edge, two are joined
  CHECK(counts(mesh, neighbours_of(mesh))[EdgeKind::kBorder] == 7);
  mesh.indices = {0, 1, 0};  // both directions of one triangle, and an edge without a length
  CHECK(counts(mesh, neighbours_of(mesh))[EdgeKind::kBorder] == 3);
}

TEST_CASE("the library reads the neighbours of a model binary") {
  const FixedMesh mesh = with_neighbours(ordered(to_fixed(made("torus:24x12"))), "torus");
  const FixedModel model = model_of(mesh);
  const std::string text = model_binary_file(model);
  CHECK(text.size() == model_bytes(CompiledOutput::kBinary, model, false));
  std::vector<std::uint32_t> words((text.size() + 3) / 4);
  std::memcpy(words.data(), text.data(), text.size());
  const std::span binary(reinterpret_cast<const std::uint8_t*>(words.data()), text.size());
  StoredModel stored;
  REQUIRE(ok(view_model_binary(binary, stored)));
  REQUIRE(stored.part_count() == 1);
  MeshNeighbours neighbours;
  REQUIRE(ok(view_neighbours(stored, 0, neighbours)));
  CHECK(neighbours.triangle_count() == mesh.indices.size() / 3);
  CHECK(std::equal(mesh.neighbours.begin(), mesh.neighbours.end(), neighbours.bytes()));
}

TEST_CASE("a model binary without neighbours says so") {
  FixedMesh mesh = to_fixed(cube());
  FixedModel model = model_of(mesh);
  model.meshes.push_back(with_neighbours(mesh, "cube"));
  model.looks.emplace_back();
  const std::string text = model_binary_file(model);
  CHECK(text.size() == model_bytes(CompiledOutput::kBinary, model, false));
  std::vector<std::uint32_t> words((text.size() + 3) / 4);
  std::memcpy(words.data(), text.data(), text.size());
  StoredModel stored;
  REQUIRE(ok(view_model_binary({reinterpret_cast<const std::uint8_t*>(words.data()), text.size()}, stored)));
  MeshNeighbours neighbours;
  CHECK(view_neighbours(stored, 0, neighbours) == Status::kUnsupported);
  CHECK(neighbours.triangle_count() == 0);
  CHECK(view_neighbours(stored, 1, neighbours) == Status::kOk);
  CHECK(neighbours.triangle_count() == 12);
}

TEST_CASE("a header has neighbours only if the model has") {
  const FixedMesh plain = to_fixed(cube());
  CHECK(model_header(model_of(plain), "box", "test").find("eighbours") == std::string::npos);
  const FixedModel model = model_of(with_neighbours(plain, "cube"));
  const std::string text = model_header(model, "box", "test");
  CHECK(text.find("#include <arcspan/mesh/mesh_neighbours.hpp>\n") != std::string::npos);
  CHECK(text.find("inline constexpr std::uint8_t kNeighbours[] = {") != std::string::npos);
  CHECK(text.find("make_neighbours(const arcspan::MeshView& view,") != std::string::npos);
  CHECK(model_bytes(CompiledOutput::kHeader, model, false) ==
        model_bytes(CompiledOutput::kHeader, model_of(plain), false) + model.meshes[0].neighbours.size());
}
