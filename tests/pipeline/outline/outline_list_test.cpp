// SPDX-License-Identifier: MIT
// Which edges are outlines: closed ones, borders, folds and creases, and each reason to refuse.
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/neighbours.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kBlinn>;
using Method = Flat<Light>;

constexpr OutlineEdge kUntouched{{1, 2, 3}, {4, 5, 6}};

TestCamera camera(Random& random, double radius) {
  TestCamera made;
  made.look_in_random_direction(random);
  made.translation = {0, 0, -4 * radius};
  made.near_plane = radius / 10;
  made.far_plane = 10 * radius;
  return made;
}

std::vector<TriangleSide> sides_of(const MeshView& mesh, const TestCamera& from, bool two_sided = false) {
  std::vector<TriangleSide> sides(mesh.triangle_count());
  const auto light = make_light<1, Highlight::kBlinn>(from);
  REQUIRE(ok(find_sides<Method>(mesh, from.transform(), light, NoCache{}, sides, {two_sided})));
  return sides;
}

bool operator<(const RasterPosition& a, const RasterPosition& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

std::vector<OutlineEdge> outlines_of(const MeshView& mesh, const TestCamera& from,
                                     const std::vector<TriangleSide>& sides, bool creases = false) {
  const TestNeighbours neighbours(mesh, creases);
  std::vector<OutlineEdge> memory(6 * mesh.triangle_count());
  OutlineList edges(memory);
  const ClipTransform transform = from.transform();
  REQUIRE(ok(edges.add(mesh, neighbours.view, VertexPositions(transform), sides)));
  return {edges.edges().begin(), edges.edges().end()};
}

/// Whether as many edges begin at each point as end there.
bool are_closed(const std::vector<OutlineEdge>& edges) {
  std::vector<RasterPosition> from;
  std::vector<RasterPosition> to;
  for (const OutlineEdge& edge : edges) {
    from.push_back(edge.from);
    to.push_back(edge.to);
  }
  const auto before = [](const RasterPosition& a, const RasterPosition& b) { return a < b; };
  std::sort(from.begin(), from.end(), before);
  std::sort(to.begin(), to.end(), before);
  return from == to;
}

/// Twice the area that the edges enclose, with the surface on their left, in 256ths of a square pixel.
std::int64_t doubled_area_of(const std::vector<OutlineEdge>& edges) {
  std::int64_t sum = 0;
  for (const OutlineEdge& e : edges) sum -= std::int64_t{e.from.x} * e.to.y - std::int64_t{e.to.x} * e.from.y;
  return sum;
}

/// The same of the triangles that are seen.
std::int64_t doubled_area_of(const MeshView& mesh, const ClipTransform& transform,
                             const std::vector<TriangleSide>& sides) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    if (sides[i] == TriangleSide::kHidden) continue;
    const TriangleIndices t = mesh.triangle(i);
    const auto at = [&](std::uint16_t v) { return project(transform(mesh.position(v)), transform); };
    const std::int64_t area = doubled_area(at(t.a), at(t.b), at(t.c));
    sum += area < 0 ? -area : area;
  }
  return sum;
}

/// A square of two triangles before the camera, or with `turned` its back.
TestMesh square(bool turned = false) {
  TestMesh mesh;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    mesh.add({9000.0 * x, 9000.0 * y, 0}, {0, 0, 1});
  mesh.triangle(0, 1, 2);
  mesh.triangle(0, 2, 3);
  return turned ? mesh.inside_out() : mesh;
}

TestCamera straight_camera() {
  TestCamera made;
  made.translation = {0, 0, -40000};
  return made;
}

}  // namespace

TEST_CASE("Outline edges: they are closed, and enclose what is seen on their left") {
  Random random(46);
  const bool two_sided = GENERATE(false, true);
  const bool has_hole = GENERATE(false, true);
  TestMesh sphere = make_sphere(9, 14, 9000, 0.3, random);
  if (has_hole) sphere.indices.resize(sphere.indices.size() * 3 / 4);
  const MeshView mesh = sphere.view();
  for (int i = 0; i < share_of(60); ++i) {
    const TestCamera from = camera(random, 9000);
    const std::vector<TriangleSide> sides = sides_of(mesh, from, two_sided);
    const std::vector<OutlineEdge> edges = outlines_of(mesh, from, sides);
    CHECK_FALSE(edges.empty());
    const bool has_hidden =  // a triangle without an area
        std::count(sides.begin(), sides.end(), TriangleSide::kHidden) != 0;
    if (two_sided && !has_hole && !has_hidden) {
      // A fold has front and back on the same side, of which only the front counts.
      const auto front = sides_of(mesh, from);
      CHECK(doubled_area_of(edges) == doubled_area_of(mesh, from.transform(), front));
    }
    if (two_sided) continue;
    CHECK(are_closed(edges));
    CHECK(doubled_area_of(edges) == doubled_area_of(mesh, from.transform(), sides));
  }
}

TEST_CASE("Outline edges: borders of fronts, and of backs if they are drawn") {
  const TestCamera from = straight_camera();
  const TestMesh front = square();
  const TestMesh back = square(true);
  CHECK(outlines_of(front.view(), from, sides_of(front.view(), from)).size() == 4);
  CHECK(outlines_of(back.view(), from, sides_of(back.view(), from)).empty());
  const auto seen = outlines_of(back.view(), from, sides_of(back.view(), from, true));
  CHECK(seen.size() == 4);
  CHECK(doubled_area_of(seen) ==
        doubled_area_of(outlines_of(front.view(), from, sides_of(front.view(), from))));
}

TEST_CASE("Outline edges: a crease is an outline of both sides, if both are seen") {
  const TestCamera from = straight_camera();
  const TestMesh front = square();
  const auto edges = outlines_of(front.view(), from, sides_of(front.view(), from), true);
  REQUIRE(edges.size() == 6);
  CHECK(are_closed(edges));
  const TestMesh back = square(true);
  CHECK(outlines_of(back.view(), from, sides_of(back.view(), from), true).empty());
  CHECK(outlines_of(back.view(), from, sides_of(back.view(), from, true), true).size() == 6);
  // With one triangle hidden the crease is the border of the other one.
  for (const std::size_t hidden : {0u, 1u}) {
    std::vector<TriangleSide> sides = sides_of(front.view(), from);
    sides[hidden] = TriangleSide::kHidden;
    const auto rest = outlines_of(front.view(), from, sides, true);
    CHECK(rest.size() == 3);
    CHECK(are_closed(rest));
  }
}

TEST_CASE("Outline edges: triangles that are cut have none, nor have their neighbours towards them") {
  const TestCamera from = straight_camera();
  const TestMesh mesh = square();
  for (const std::size_t cut : {0u, 1u}) {
    std::vector<TriangleSide> sides = sides_of(mesh.view(), from);
    sides[cut] = TriangleSide::kCut;
    CHECK(outlines_of(mesh.view(), from, sides).size() == 2);
    sides[1 - cut] = TriangleSide::kHidden;
    CHECK(outlines_of(mesh.view(), from, sides).empty());
  }
}

TEST_CASE("Outline edges: a cache has the positions that the transform gives") {
  Random random(47);
  const TestMesh sphere = make_sphere(9, 14, 9000, 0.1, random);
  const MeshView mesh = sphere.view();
  const TestCamera from = camera(random, 9000);
  const ClipTransform transform = from.transform();
  const auto light = make_light<1, Highlight::kBlinn>(from);
  std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
  std::vector<TriangleSide> sides(mesh.triangle_count());
  VertexCache<Method> cache(vertices);
  REQUIRE(ok(find_sides<Method>(mesh, transform, light, cache, sides)));
  const TestNeighbours neighbours(mesh);
  std::vector<OutlineEdge> memory(mesh.triangle_count());
  OutlineList edges(memory);
  const std::span<const CachedVertex<Method>> cached(vertices);
  REQUIRE(ok(edges.add(mesh, neighbours.view, VertexPositions(transform, cached), sides)));
  const auto expected = outlines_of(mesh, from, sides);
  REQUIRE(edges.edges().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(edges.edges()[i].from == expected[i].from);
    CHECK(edges.edges()[i].to == expected[i].to);
  }
  CHECK(edges.add(mesh, neighbours.view, VertexPositions(transform, cached.first(cached.size() - 1)),
                  sides) == Status::kInvalidArgument);
}

TEST_CASE("Outline edges: what is refused adds nothing") {
  const TestCamera from = straight_camera();
  const ClipTransform transform = from.transform();
  const VertexPositions positions(transform);
  const TestMesh mesh = square();
  const TestNeighbours neighbours(mesh.view());
  const std::vector<TriangleSide> sides = sides_of(mesh.view(), from);
  std::vector<OutlineEdge> memory(7, kUntouched);
  OutlineList edges(memory);
  CHECK(edges.add(mesh.view(), {}, positions, sides) == Status::kUnsupported);
  CHECK(edges.add(mesh.view(), neighbours.view, positions, std::span(sides).first(1)) ==
        Status::kInvalidArgument);
  CHECK(edges.add(mesh.view().part(0, 1), neighbours.view, positions, sides) == Status::kInvalidArgument);
  CHECK(edges.edges().empty());
  REQUIRE(ok(edges.add(mesh.view(), neighbours.view, positions, sides)));
  CHECK(edges.add(mesh.view(), neighbours.view, positions, sides) == Status::kBufferTooSmall);
  CHECK(edges.edges().size() == 4);
  TestCamera wider = from;
  ++wider.width;
  const ClipTransform other = wider.transform();
  CHECK(edges.add(mesh.view(), neighbours.view, VertexPositions(other), sides) == Status::kInvalidArgument);
  edges.clear();
  CHECK(ok(edges.add(mesh.view(), neighbours.view, VertexPositions(other), sides)));
  CHECK(edges.viewport() == other.viewport());
  CHECK(ok(edges.add({}, {}, VertexPositions(other), {})));
}

TEST_CASE("Outline edges: ends that only hidden triangles have, which planes leave without a transform") {
  // Each triangle of a sphere has vertices of its own.
  Random random(50);
  const TestMesh whole = make_sphere(6, 9, 9000, 0, random);
  TestMesh split;
  for (const std::uint16_t i : whole.indices) {
    split.positions.push_back(whole.positions[i]);
    split.normals.push_back(whole.normals[i]);
    split.indices.push_back(static_cast<std::uint16_t>(split.indices.size()));
  }
  MeshView mesh = split.view();
  std::vector<FacePlane> planes(mesh.triangle_count());
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(mesh, planes, scale)));
  REQUIRE(ok(mesh.attach(planes, scale)));
  const TestNeighbours neighbours(mesh);
  for (int repeat = 0; repeat < share_of(50) + 3; ++repeat) {
    const TestCamera from = camera(random, 9000);
    const ClipTransform transform = from.transform();
    const auto light = make_light<1, Highlight::kBlinn>(from);
    std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
    for (auto& vertex : vertices) vertex.raster.position = {-32000, 32000, 1};  // of an earlier frame
    VertexCache<Method> cache(vertices);
    std::vector<TriangleSide> sides(mesh.triangle_count());
    REQUIRE(ok(find_sides<Method>(mesh, transform, light, cache, sides)));
    std::vector<OutlineEdge> memory(3 * mesh.triangle_count());
    OutlineList edges(memory);
    const VertexPositions positions(transform, std::span<const CachedVertex<Method>>(vertices));
    REQUIRE(ok(edges.add(mesh, neighbours.view, positions, sides)));
    const std::vector<OutlineEdge> found(edges.edges().begin(), edges.edges().end());
    CHECK(!found.empty());
    CHECK(are_closed(found));
    const auto same = [](const OutlineEdge& a, const OutlineEdge& b) {
      return a.from == b.from && a.to == b.to;
    };
    const std::vector<OutlineEdge> expected = outlines_of(mesh, from, sides);
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), same));
  }
}
