// SPDX-License-Identifier: MIT
// Room in 16-bit positions for curves over outlines.
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/shading/unlit.hpp>

#include <arcspan_tools/image/image_file.hpp>
#include <arcspan_tools/mesh/compile/neighbours.hpp>
#include <arcspan_tools/mesh/plain/generate.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/tools/command_run.hpp>
#include <tests/tools/temporary_folder.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::tools;
using namespace arcspan::test;

namespace {

/// A mesh of the generator that is flat in z, turned until the outermost edges lie across the axes x and y.
MeshData turned(const std::string& name, double degrees) {
  MeshData mesh = generate(parse_generated_mesh(name).value());
  const double s = std::sin(degrees * kDegree);
  const double c = std::cos(degrees * kDegree);
  for (Vec3& p : mesh.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y, 0.9 * p.z};
  for (Vec3& n : mesh.normals) n = normalised(Vec3{c * n.x - s * n.y, s * n.x + c * n.y, n.z / 0.9});
  return mesh;
}
MeshData turned_sphere() { return turned("sphere:16x8", 11.25); }

/// The worst status of CurvedOutlines over many views, and the largest coordinate of curves.
struct Found {
  Status status = Status::kOk;
  std::int32_t outermost = 0;
};

Found find_curves(const MeshData& data, bool has_room) {
  Model model = to_model(data);
  model.has_curves = has_room;
  const FixedMesh mesh = with_neighbours(to_fixed(model).meshes[0], "test");
  const MeshView view = mesh.view("test");
  MeshNeighbours neighbours;
  REQUIRE(ok(MeshNeighbours::make(view, mesh.neighbours, neighbours)));
  const auto memory = std::make_unique<CurveMemory<MeshView::kMaxVertices / 3>>();
  std::vector<TriangleSide> sides(view.triangle_count());
  std::vector<OutlineEdge> edges(6 * view.triangle_count());
  Found found;
  for (int i = 0; i < 60; ++i) {
    Scene scene;
    const double turn = 0.7 * i;
    const double up = (i % 20 - 9.5) / 10;
    scene.camera.eye = Vec3{9 * std::cos(turn), 9 * std::sin(turn), 9 * up};
    const ClipTransform transform = make_job(scene, mesh, "test").transform;
    REQUIRE(ok(find_sides<Unlit>(view, transform, Unlit::lighting({}), NoCache{}, sides)));
    OutlineList outlines(edges);
    CurvedOutlines curves(*memory);
    const Status status = curves.add(view, neighbours, VertexPositions(transform), sides, outlines);
    if (!ok(status)) found.status = status;
    for (std::size_t v = 2; v < curves.mesh().vertex_count(); v += 3) {
      const ObjectPosition p = curves.mesh().position(v);
      for (const std::int32_t coordinate : {p.x, p.y, p.z})
        found.outermost = std::max(found.outermost, std::abs(coordinate));
    }
  }
  return found;
}

/// Columns and rows of a picture that are not all background.
std::pair<int, int> extent(const Image& image) {
  int left = image.width, right = -1, top = image.height, bottom = -1;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.at(x, y) == image.at(0, 0)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return {right - left + 1, bottom - top + 1};
}

/// The text of an .obj file.
std::string obj_text(const MeshData& mesh) {
  std::ostringstream text;
  for (const Vec3& p : mesh.positions) text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const Vec3& n : mesh.normals) text << "vn " << n.x << ' ' << n.y << ' ' << n.z << '\n';
  for (const auto& t : mesh.triangles) {
    text << 'f';
    for (const std::uint32_t i : t) text << ' ' << i + 1 << "//" << i + 1;
    text << '\n';
  }
  return text.str();
}

}  // namespace

TEST_CASE("curves over all outlines fit 16 bits, with hardly more room than they need") {
  for (const MeshData& mesh : {turned_sphere(), turned("sphere:8x4", 22.5), turned("torus:12x8", 15)}) {
    INFO(mesh.triangles.size());
    CHECK(find_curves(mesh, false).status == Status::kScaleOutOfRange);
    const Found found = find_curves(mesh, true);
    CHECK(ok(found.status));
    CHECK(found.outermost > 32767 - 30);
  }
}

TEST_CASE("a model that moves has room for curves on all sides") {
  Model model = to_model(turned_sphere());
  model.has_curves = true;
  const double still = to_fixed(model).meshes[0].unit;
  model.rig = std::make_shared<Rig>();
  model.reach = box_of(model);
  CHECK(to_fixed(model).meshes[0].unit > 1.001 * still);
}

TEST_CASE("the option --curved-outlines curves the outermost edges, too, of models and of what mesh writes") {
  const TemporaryFolder folder;
  const std::string sphere = folder.file("turned.obj", obj_text(turned_sphere()));
  const auto drawn = [&](const std::string& model, const std::string& options) {
    REQUIRE(run("render " + model + " --size 240x240 --eye 0,0,40 --target 0,0,0 --fov 3.5 -o " +
                (folder / "a.ppm") + options)
                .status == 0);
    return extent(read_image(folder / "a.ppm"));
  };
  const auto straight = drawn(sphere, "");
  const auto curved = drawn(sphere, " --curved-outlines");
  CHECK(straight.first == straight.second);
  CHECK(curved.first >= straight.first + 3);
  CHECK(curved.second >= straight.second + 3);
  const auto figures = [&](const std::string& options) {
    REQUIRE(run("mesh " + sphere + " -o " + (folder / "a.bin") + " --stats " + (folder / "a.json") + options)
                .status == 0);
    return nlohmann::json::parse(contents(folder / "a.json"))["mesh"];
  };
  const auto plain = figures(" --outlines");
  const auto roomy = figures(" --curved-outlines");
  CHECK(roomy["neighbours"] == true);
  CHECK(roomy["bytes"] == plain["bytes"]);
  CHECK(roomy["unit"].get<double>() > 1.01 * plain["unit"].get<double>());
  CHECK(roomy["unit"].get<double>() < 1.02 * plain["unit"].get<double>());
}
