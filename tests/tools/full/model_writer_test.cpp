// SPDX-License-Identifier: MIT
// Models with parts and materials: the header and the binary that `arcspan mesh` writes.
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/model/model_binary.hpp>

#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/mesh/compile/compile_mesh.hpp>
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/output/mesh_writer.hpp>
#include <catch2/catch.hpp>
#include <lamp.hpp>  // made by the build from models/lamp.obj
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

const std::string kLamp = ARCSPAN_MODELS "/lamp.obj";

FixedModel lamp_model() { return to_fixed(load_model_file(kLamp)); }

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

bool same(const ChannelCoefficients& a, const ChannelCoefficients& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

bool same(const Material& a, const Material& b) {
  return same(a.ambient, b.ambient) && same(a.diffuse, b.diffuse) && same(a.specular, b.specular) &&
         a.shininess == b.shininess;
}

Status read(const std::vector<std::uint8_t>& bytes) {
  StoredModel model;
  return view_model_binary(bytes, model);
}

/// A sphere whose upper half is one part and whose lower half another.
Model two_halves() {
  const Model whole = load_model_file("sphere:64x32");
  RawModel raw = to_raw(whole);
  raw.looks = {{{"upper"}, {}}, {{"lower"}, {}}};
  for (std::size_t i = 0; i < raw.look_of.size(); ++i) {
    const auto& t = raw.mesh.triangles[i];
    raw.look_of[i] = t[0].position.y + t[1].position.y + t[2].position.y > 0 ? 0 : 1;
  }
  return weld_parts(raw, "halves");
}

}  // namespace

TEST_CASE("the header of a model has its parts, their materials, and the unit and origin that they share") {
  REQUIRE(std::size(lamp::kParts) == 2);
  MeshView stand;
  MeshView bulb;
  REQUIRE(ok(lamp::kParts[0].make_view(stand)));
  REQUIRE(ok(lamp::mesh_switch::make_view(bulb)));
  CHECK(stand.triangle_count() == 4);
  CHECK(bulb.triangle_count() == 2);
  CHECK(lamp::kMostVertices == stand.vertex_count());
  STATIC_REQUIRE(lamp::stand::kMaterial.shininess == 90);
  const FixedModel model = lamp_model();
  CHECK(same(*lamp::kParts[0].material, material_of(model.looks[0])));
  CHECK(same(*lamp::kParts[1].material, material_of(model.looks[1])));
  CHECK_FALSE(lamp::kParts[1].two_sided);
  // The bulb's top is the model's highest point: its place is the model's when unit and origin are applied.
  double top = 0;
  for (std::size_t i = 0; i < bulb.vertex_count(); ++i) {
    top = std::max(top, lamp::kOrigin[1] + bulb.position(i).y * lamp::kUnit);
  }
  CHECK(top == Approx(3).margin(1e-4));
}

TEST_CASE("materials in a firmware: the file's, with the shares of light of a picture, or white plastic") {
  const Material brass = material_of(lamp_model().looks[0]);
  CHECK(brass.diffuse.r == Coefficient::of(0.8 * 0.78));
  CHECK(brass.ambient.b == Coefficient::of(0.2 * 0.14));
  CHECK(brass.specular.g == Coefficient::of(0.8));
  const Material glow = material_of(lamp_model().looks[1]);
  CHECK(glow.ambient.b == Coefficient::of(0.8));
  CHECK(glow.diffuse.r == Coefficient::of(0.0));
  CHECK(glow.specular.r == Coefficient::of(0.0));
  FileMaterial silent;  // of its look
  silent.name = "clay";
  silent.two_sided = true;
  CHECK(same(material_of({{}, silent}), plastic({255, 255, 255})));
  silent.shininess = 9;
  const Material dull = material_of({{}, silent});
  CHECK(dull.shininess == 9);
  CHECK(same(dull.diffuse, {Coefficient::of(0.78), Coefficient::of(0.78), Coefficient::of(0.78)}));
}

TEST_CASE("the library reads the model binary that was written") {
  const FixedModel model = lamp_model();
  const std::string text = model_binary_file(model);
  CHECK(text.size() == model_bytes(CompiledOutput::kBinary, model, false));
  const std::vector<std::uint8_t> bytes = bytes_of(text);
  StoredModel stored;
  REQUIRE(ok(view_model_binary(bytes, stored)));
  REQUIRE(stored.part_count() == 2);
  CHECK(stored.most_vertices() ==
        std::max(model.meshes[0].positions.size(), model.meshes[1].positions.size()));
  CHECK(std::string(stored.part(0).name) == "stand");
  CHECK(std::string(stored.part(1).name) == "switch");
  for (std::size_t i = 0; i < stored.part_count(); ++i) {
    const arcspan::ModelPart part = stored.part(i);
    CHECK(same(part.material, material_of(model.looks[i])));
    CHECK(part.sphere == bounding_sphere(part.mesh));
    REQUIRE(part.mesh.vertex_count() == model.meshes[i].positions.size());
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) {
      CHECK(part.mesh.position(v) == model.meshes[i].positions[v]);
    }
  }
}

TEST_CASE("the sphere of a model binary contains the vertices of all parts, and is as small as one can be") {
  const FixedModel model = lamp_model();
  const std::vector<std::uint8_t> bytes = bytes_of(model_binary_file(model));
  StoredModel stored;
  REQUIRE(ok(view_model_binary(bytes, stored)));
  const BoundingSphere sphere = stored.sphere();
  double farthest = 0;
  for (const FixedMesh& mesh : model.meshes) {
    for (const ObjectPosition& p : mesh.positions) {
      farthest =
          std::max(farthest, std::hypot(p.x - sphere.middle.x, p.y - sphere.middle.y, p.z - sphere.middle.z));
    }
  }
  CHECK(farthest <= sphere.radius);
  CHECK(farthest > sphere.radius - 1);
  // The lamp's longest side, which fills 16 bits, goes through the middle.
  CHECK(sphere.middle == ObjectPosition{0, 0, 0});
  CHECK(sphere.radius >= 32767);
}

TEST_CASE("a damaged model binary is refused, whichever byte is wrong") {
  const std::vector<std::uint8_t> good = bytes_of(model_binary_file(lamp_model()));
  REQUIRE(ok(read(good)));
  for (std::size_t size = 0; size < good.size(); ++size) {
    const std::vector<std::uint8_t> cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    CHECK(read(cut) == Status::kTruncated);
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::vector<std::uint8_t> wrong = good;
    wrong[at] ^= 0x20;
    CHECK_FALSE(ok(read(wrong)));
  }
  std::vector<std::uint8_t> longer = good;
  longer.push_back(0);
  CHECK(ok(read(longer)));
}

TEST_CASE("parts keep their common border when they are simplified together") {
  const Model halves = two_halves();
  REQUIRE(halves.parts.size() == 2);
  const BytesOf bytes_of_model = [](const FixedModel& m) { return m.bytes(); };
  const CompiledModel few = compile_model(halves, {600, {}, {}}, bytes_of_model, "test", [](std::size_t) {});
  REQUIRE(few.model.meshes.size() == 2);
  CHECK(few.model.triangle_count() <= 600);
  CHECK(few.model.triangle_count() > 500);
  CHECK(few.model.meshes[0].unit == few.model.meshes[1].unit);
  CHECK(few.model.meshes[0].centre == few.model.meshes[1].centre);
  // Every edge of one part that no other triangle of it has is on the border, and the other part has it too.
  using Edge = std::pair<std::array<int, 3>, std::array<int, 3>>;
  const auto borders = [](const FixedMesh& mesh) {
    std::vector<Edge> open;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const auto at = [&mesh](std::size_t corner) {
        const ObjectPosition& p = mesh.positions[mesh.indices[corner]];
        return std::array<int, 3>{p.x, p.y, p.z};
      };
      const Edge edge{at(i), at(i % 3 == 2 ? i - 2 : i + 1)};
      const auto back = std::find(open.begin(), open.end(), Edge{edge.second, edge.first});
      if (back == open.end()) {
        open.push_back(edge);
      } else {
        open.erase(back);
      }
    }
    return open;
  };
  const std::vector<Edge> upper = borders(few.model.meshes[0]);
  const std::vector<Edge> lower = borders(few.model.meshes[1]);
  CHECK(upper.size() > 8);
  CHECK(upper.size() == lower.size());
  for (const Edge& edge : upper)
    CHECK(std::count(lower.begin(), lower.end(), Edge{edge.second, edge.first}) == 1);
}

TEST_CASE("parts that cannot be simplified together are clustered one by one, each in its material") {
  Model cubes;
  for (int i = 0; i < 2; ++i) {
    tools::ModelPart part{{{"part" + std::to_string(i)}, {}}, {}};
    const Model sphere = load_model_file("sphere:24x12");
    for (const Vec3& p : sphere.parts[0].mesh.positions)
      part.mesh.positions.push_back(p + Vec3{2.5 * i, 0, 0});
    part.mesh.normals = sphere.parts[0].mesh.normals;
    part.mesh.triangles = sphere.parts[0].mesh.triangles;
    cubes.parts.push_back(part);
  }
  const Simplified few = simplify(cubes, Simplification::kByCells, 120, 60, "test");
  REQUIRE(few.model.parts.size() == 2);
  CHECK(few.model.triangle_count() <= 120);
  CHECK(few.model.triangle_count() > 20);
  for (const Vec3& p : few.model.parts[0].mesh.positions) CHECK(p.x < 1.25);
  for (const Vec3& p : few.model.parts[1].mesh.positions) CHECK(p.x > 1.25);
}

TEST_CASE("mesh: parts and materials in figures, binaries and pictures; one part by its name") {
  const TemporaryFolder folder;
  const std::string bin = folder / "lamp.bin";
  const CommandRun made = run("mesh " + kLamp + " -o " + bin + " --stats " + (folder / "s.json"));
  REQUIRE(made.status == 0);
  CHECK(made.out.find(", 8-bit indices, 2 parts\n  stand: ") != std::string::npos);
  CHECK(made.out.find("  switch: 4 vertices, 2 triangles, diffuse 0.00,0.00,0.00") != std::string::npos);
  CHECK(contents(folder / "s.json").find("\"name\": \"switch\"") != std::string::npos);
  // The binary draws as the model does.
  REQUIRE(run("render " + kLamp + " -o " + (folder / "a.ppm")).status == 0);
  REQUIRE(run("render " + bin + " -o " + (folder / "b.ppm")).status == 0);
  const CommandRun compared = run("diff " + (folder / "a.ppm") + " " + (folder / "b.ppm"));
  INFO(compared.out);
  CHECK(std::stod(compared.out.substr(compared.out.find("mean ") + 5)) < 0.1);
  REQUIRE(run("mesh " + bin + " -o " + (folder / "again.bin")).status == 0);
  CHECK(contents(folder / "again.bin") == contents(bin));
  const CommandRun one = run("mesh " + kLamp + " --group stand -o " + (folder / "stand.hpp"));
  REQUIRE(one.status == 0);
  const std::string header = contents(folder / "stand.hpp");
  CHECK(header.find("arcspan::Material kMaterial = {") != std::string::npos);
  CHECK(header.find("4 triangles") != std::string::npos);
  CHECK(run("mesh " + kLamp + " --group shade -o " + (folder / "no.hpp")).err ==
        "arcspan: " + kLamp + ": no group 'shade' (there are: lamp, stand, switch)\n");
}

TEST_CASE("mesh: a damaged model binary is refused in one line") {
  const TemporaryFolder folder;
  std::string bytes = model_binary_file(lamp_model());
  const std::string cut = folder.file("cut.bin", bytes.substr(0, 100));
  CHECK(run("render " + cut + " -o " + (folder / "a.png")).err ==
        "arcspan: " + cut + ": the model binary is damaged (truncated)\n");
  bytes[60] = static_cast<char>(bytes[60] ^ 1);
  const std::string bad = folder.file("bad.bin", bytes);
  CHECK(run("render " + bad + " -o " + (folder / "a.png")).err ==
        "arcspan: " + bad + ": the model binary is damaged (corrupted)\n");
  bytes[4] = 2;
  const std::string old = folder.file("old.bin", bytes);
  CHECK(run("render " + old + " -o " + (folder / "a.png")).err ==
        "arcspan: " + old +
            ": a model binary of version 2, not 3: write it again by arcspan mesh MODEL -o NAME.bin\n");
}
