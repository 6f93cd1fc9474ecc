// SPDX-License-Identifier: MIT
// Curves over the outlines of coarse meshes: nearer to the round shape, without cracks, the same in bands.
#include <arcspan/outline/curved_outlines.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/outline/outline_pictures.hpp>
#include <tests/support/circle.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// A sphere of 16x8 in the middle of the picture, with its outlines straight or curved.
struct CurvedScene {
  using Method = OutlineScene::Method;
  using Memory = CurveMemory<200>;

  CurvedScene(Random& random, double radius, bool is_curved)
      : sphere(make_sphere(8, 16, radius, 0, random)),
        neighbours(sphere.view()),
        from(camera_of(random, radius)),
        transform(from.transform()),
        sides(sphere.view().triangle_count()),
        edges(1000),
        outlines(edges) {
    REQUIRE(ok(find_sides<Method>(sphere.view(), transform, light(), NoCache{}, sides)));
    const VertexPositions positions(transform);
    status = is_curved ? curves.add(sphere.view(), neighbours.view, positions, sides, outlines)
                       : outlines.add(sphere.view(), neighbours.view, positions, sides);
  }
  [[nodiscard]] Illumination<1, Highlight::kBlinn> light() const {
    return make_light<1, Highlight::kBlinn>(from);
  }
  void draw(Picture& picture) const {
    for (const MeshView& mesh : {view, curves.mesh()})
      REQUIRE(ok(draw_mesh<Method>(mesh, transform, light(), picture.frame, picture.depth).status));
  }

  TestMesh sphere;
  MeshView view = sphere.view();
  TestNeighbours neighbours;
  TestCamera from;
  ClipTransform transform;
  std::vector<TriangleSide> sides;
  std::vector<OutlineEdge> edges;
  OutlineList outlines;
  std::unique_ptr<Memory> memory = std::make_unique<Memory>();
  CurvedOutlines curves{*memory};
  Status status = Status::kOk;
};

[[nodiscard]] std::int64_t doubled_area_within(const OutlineList& outlines) {
  std::int64_t sum = 0;
  for (const OutlineEdge& e : outlines.edges())
    sum -= std::int64_t{e.from.x} * e.to.y - std::int64_t{e.to.x} * e.from.y;
  return sum;
}

/// That of the fronts of a mesh.
[[nodiscard]] std::int64_t doubled_area_within(const MeshView& mesh, const ClipTransform& transform) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleIndices t = mesh.triangle(i);
    const auto at = [&](std::size_t v) { return project(transform(mesh.position(v)), transform); };
    sum += std::max(0, -doubled_area(at(t.a), at(t.b), at(t.c)));
  }
  return sum;
}

}  // namespace

TEST_CASE("Curved outlines: those of a sphere of 16x8 deviate from a circle by half as much") {
  Random random(80);
  double straight_sum = 0;
  double curved_sum = 0;
  bool is_on_sphere = true;
  const int views = std::max(12, share_of(60));
  for (int i = 0; i < views; ++i) {
    Random again = random;
    const CurvedScene straight(again, 9000, false);
    const CurvedScene curved(random, 9000, true);
    REQUIRE(ok(straight.status));
    REQUIRE(ok(curved.status));
    REQUIRE(curved.curves.mesh().triangle_count() > 4);
    const double radius = curved.from.focal / std::sqrt(4.0 * 4.0 - 1);  // in perspective
    for (std::size_t m = 2; m < curved.curves.mesh().vertex_count(); m += 3) {
      const ObjectPosition& p = curved.curves.mesh().position(m);
      const double length = std::hypot(1.0 * p.x, 1.0 * p.y, 1.0 * p.z);
      is_on_sphere = is_on_sphere && std::abs(length / 9000 - 1) < 0.012;
    }
    straight_sum += deviation_from_circle(straight.outlines, radius);
    curved_sum += deviation_from_circle(curved.outlines, radius);
  }
  CHECK(is_on_sphere);
  CHECK(curved_sum < 0.6 * straight_sum);
}

TEST_CASE("Curved outlines: surface and curves have no cracks and do not overlap") {
  Random random(81);
  for (int i = 0; i < share_of(60); ++i) {
    const CurvedScene scene(random, 9000, true);
    const std::size_t curves = scene.curves.mesh().triangle_count();
    REQUIRE(curves > 4);
    CHECK(scene.outlines.edges().size() >= 2 * curves);
    CHECK(doubled_area_within(scene.outlines) ==
          doubled_area_within(scene.view, scene.transform) +
              doubled_area_within(scene.curves.mesh(), scene.transform));
  }
}

TEST_CASE("Curved outlines: edges that are seen nearly end-on have no spikes") {
  Random random(84);
  for (int i = 0; i < share_of(600); ++i) {
    const CurvedScene scene(random, 9000, true);
    const MeshView curves = scene.curves.mesh();
    double sharpest = 0;
    for (std::size_t v = 0; v < curves.vertex_count(); v += 3) {
      const auto at = [&](std::size_t k) {
        return project(scene.transform(curves.position(v + k)), scene.transform);
      };
      const double length = std::hypot(at(1).x - at(0).x, at(1).y - at(0).y);
      const double area = std::abs(doubled_area(at(0), at(1), at(2)));
      sharpest = std::max(sharpest, area / (length * length));
    }
    REQUIRE(sharpest < 0.5);
  }
}

TEST_CASE("Curved outlines: smoothed bands are the whole picture") {
  Random random(82);
  for (int i = 0; i < share_of(30); ++i) {
    const CurvedScene scene(random, 9000, true);
    const Rect all{0, 0, scene.from.width, scene.from.height};
    Picture whole(all);
    scene.draw(whole);
    REQUIRE(ok(smooth(scene.outlines, whole)));
    const std::int32_t rows = random.integer(5, 30);
    for (std::int32_t top = 0; top < all.bottom; top += rows) {
      const Rect sent{0, top, all.right, std::min(all.bottom, top + rows)};
      Picture band({0, std::max(0, top - 1), all.right, std::min(all.bottom, sent.bottom + 1)});
      scene.draw(band);
      REQUIRE(ok(smooth(scene.outlines, band)));
      CHECK(same_pixels(whole, band, sent));
    }
  }
}

TEST_CASE("Curved outlines: sharp edges and borders stay straight") {
  Random random(83);
  const TestCamera from = camera_of(random, 9000);
  const ClipTransform transform = from.transform();
  TestMesh square;
  for (const int i : {0, 1, 2, 3}) {
    const double x = i == 1 || i == 2 ? 6000 : -6000;
    const double y = i > 1 ? 6000 : -6000;
    // Normals that lean outward, as those of a dome.
    square.add(x * from.right + y * from.up, normalised(x * from.right + y * from.up + 6000 * from.back));
  }
  square.triangle(0, 1, 2);
  square.triangle(0, 2, 3);
  for (const TestMesh& mesh : {make_smooth_tetrahedron(6000), square}) {
    const MeshView view = mesh.view();
    const TestNeighbours neighbours(view);
    std::vector<TriangleSide> sides(view.triangle_count());
    const auto light = make_light<1, Highlight::kBlinn>(from);
    REQUIRE(ok(find_sides<CurvedScene::Method>(view, transform, light, NoCache{}, sides)));
    std::vector<OutlineEdge> memory(100);
    std::vector<OutlineEdge> straight_memory(100);
    OutlineList outlines(memory);
    OutlineList straight(straight_memory);
    CurveMemory<50> curve_memory;
    CurvedOutlines curves(curve_memory);
    CHECK(ok(curves.add(view, neighbours.view, VertexPositions(transform), sides, outlines)));
    REQUIRE(ok(straight.add(view, neighbours.view, VertexPositions(transform), sides)));
    CHECK(curves.mesh().triangle_count() == 0);
    CHECK(straight.edges().size() >= 3);
    CHECK(outlines.edges().size() == straight.edges().size());
  }
}

TEST_CASE("Curved outlines: without room or memory edges stay straight, and the status says so") {
  Random random(84);
  // A curve over the edge of a cube that fills 16 bits leaves them.
  const TestMesh cube = make_smooth_cube(32767);
  const MeshView view = cube.view();
  const TestNeighbours neighbours(view);
  const TestCamera from = camera_of(random, 32767);
  const ClipTransform transform = from.transform();
  std::vector<TriangleSide> sides(view.triangle_count());
  REQUIRE(ok(find_sides<CurvedScene::Method>(view, transform, make_light<1, Highlight::kBlinn>(from),
                                             NoCache{}, sides)));
  std::vector<OutlineEdge> cube_edges(100);
  OutlineList cube_outlines(cube_edges);
  CurveMemory<50> cube_memory;
  CurvedOutlines cube_curves(cube_memory);
  CHECK(cube_curves.add(view, neighbours.view, VertexPositions(transform), sides, cube_outlines) ==
        Status::kScaleOutOfRange);
  CHECK(cube_curves.mesh().triangle_count() == 0);
  CHECK(cube_outlines.edges().size() >= 4);

  CurvedScene scene(random, 9000, true);
  const std::size_t curves = scene.curves.mesh().triangle_count();
  const std::size_t edges = scene.outlines.edges().size();
  REQUIRE(curves > 4);
  const auto find = [&scene](auto& memory, std::size_t edge_count, OutlineList& outlines,
                             CurvedOutlines& found) {
    scene.edges.resize(edge_count);
    outlines = OutlineList(scene.edges);
    found = CurvedOutlines(memory);
    return found.add(scene.view, scene.neighbours.view, VertexPositions(scene.transform), scene.sides,
                     outlines);
  };
  OutlineList outlines(scene.edges);
  CurveMemory<2> few;
  CurvedOutlines found(few);
  CHECK(find(few, edges, outlines, found) == Status::kBufferTooSmall);
  CHECK(found.mesh().triangle_count() == 2);
  CHECK(outlines.edges().size() == edges - curves + 2);
  CHECK(find(*scene.memory, edges - 1, outlines, found) == Status::kBufferTooSmall);
  CHECK(found.mesh().triangle_count() == 0);
  CHECK(outlines.edges().empty());
  CHECK(ok(find(*scene.memory, edges, outlines, found)));

  CHECK(found.add(scene.view, MeshNeighbours{}, VertexPositions(scene.transform), scene.sides, outlines) ==
        Status::kUnsupported);
  CHECK(found.count() == curves);
  CHECK(outlines.edges().size() == edges);
}

TEST_CASE("Curved outlines: objects share a memory, and each has its own mesh") {
  Random random(85);
  const CurvedScene one(random, 9000, true);
  const CurvedScene other(random, 9000, true);
  CurveMemory<200> memory;
  CurvedOutlines both(memory);
  std::vector<OutlineEdge> edges(1000);
  for (const CurvedScene* scene : {&one, &other}) {
    OutlineList outlines(edges);
    REQUIRE(ok(both.add(scene->view, scene->neighbours.view, VertexPositions(scene->transform), scene->sides,
                        outlines)));
  }
  const std::size_t first = one.curves.count();
  REQUIRE(both.count() == first + other.curves.count());
  CHECK(both.mesh().triangle_count() == both.count());
  const auto same = [](const MeshView& a, const MeshView& b) {
    bool all = a.triangle_count() == b.triangle_count() && a.vertex_count() == b.vertex_count();
    for (std::size_t i = 0; all && i < a.vertex_count(); ++i)
      all = a.position(i) == b.position(i) && a.normal(i) == b.normal(i);
    return all;
  };
  CHECK(same(both.mesh(0, first), one.curves.mesh()));
  CHECK(same(both.mesh(first, 65535), other.curves.mesh()));
  CHECK(both.mesh(first, first).triangle_count() == 0);
  CHECK(both.mesh(70000, 65535).triangle_count() == 0);
  both.clear();
  CHECK(both.mesh().triangle_count() == 0);
}

TEST_CASE("Curved outlines: the shortest array says how many curves there are") {
  Random random(86);
  const CurvedScene scene(random, 9000, true);
  REQUIRE(scene.curves.count() > 4);
  for (int shortest = 0; shortest < 3; ++shortest) {
    const auto size = [shortest](int array) { return array == shortest ? 8u : 300u; };
    std::vector<ObjectPosition> positions(size(0));
    std::vector<PackedNormal> normals(size(1));
    std::vector<std::uint16_t> indices(size(2));
    CurvedOutlines curves(positions, normals, indices);
    std::vector<OutlineEdge> edges(1000);
    OutlineList outlines(edges);
    CHECK(curves.add(scene.view, scene.neighbours.view, VertexPositions(scene.transform), scene.sides,
                     outlines) == Status::kBufferTooSmall);
    CHECK(curves.count() == 2);
    CHECK(curves.mesh().triangle_count() == 2);
  }
}
