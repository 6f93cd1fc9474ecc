// SPDX-License-Identifier: MIT
// The sides of triangles: noted while drawing, found without, and those of an independent count.
#include <arcspan/draw.hpp>
#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kBlinn>;
using Method = Flat<Light>;
using Frame = hal::Framebuffer<Rgb565>;

struct Picture {
  Picture(std::int32_t width, std::int32_t height)
      : colours(Frame::words(width, height)),
        depths(DepthBuffer::words(width, height)),
        frame(colours, width, height),
        depth(depths, width, height) {
    frame.clear({200, 210, 220});
    depth.clear();
  }
  std::vector<std::uint16_t> colours;
  std::vector<std::uint16_t> depths;
  Frame frame;
  DepthBuffer depth;
};

/// A camera from somewhere around a mesh of this radius; a near one cuts it.
TestCamera camera(Random& random, double radius, bool near) {
  TestCamera made;
  made.look_in_random_direction(random);
  made.translation = {random.real(-0.3, 0.3) * radius, random.real(-0.3, 0.3) * radius,
                      -radius * (near ? random.real(0.2, 1.4) : random.real(2.5, 5))};
  made.near_plane = radius / 10;
  made.far_plane = 10 * radius;
  return made;
}

/// What a triangle shows, by the projected vertices themselves.
TriangleSide side_by_projection(const MeshView& mesh, std::size_t i, const ClipTransform& transform,
                                bool two_sided) {
  const TriangleIndices t = mesh.triangle(i);
  RasterPosition seen[3];
  unsigned all = 31;
  unsigned any = 0;
  std::size_t n = 0;
  for (const std::uint16_t v : {t.a, t.b, t.c}) {
    const ClipPosition p = transform(mesh.position(v));
    const unsigned code = outcode(p, transform.w_range());
    all &= code;
    any |= code;
    if (code == 0) seen[n] = project(p, transform);
    ++n;
  }
  if (all != 0) return TriangleSide::kHidden;
  if (any != 0) return TriangleSide::kCut;
  const std::int64_t area = std::int64_t{seen[1].x - seen[0].x} * (seen[2].y - seen[0].y) -
                            std::int64_t{seen[2].x - seen[0].x} * (seen[1].y - seen[0].y);
  if (area < 0) return TriangleSide::kFront;
  return area > 0 && two_sided ? TriangleSide::kBack : TriangleSide::kHidden;
}

}  // namespace

TEST_CASE("Triangle sides: drawing notes those that are found without it, and draws the same picture") {
  Random random(46);
  const bool with_planes = GENERATE(false, true);
  const bool two_sided = GENERATE(false, true);
  const TestMesh sphere = make_sphere(9, 14, 9000, 0.3, random);
  MeshView mesh = sphere.view();
  std::vector<FacePlane> planes(mesh.triangle_count());
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(mesh, planes, scale)));
  if (with_planes) REQUIRE(ok(mesh.attach(planes, scale)));
  std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
  std::vector<TriangleRows> rows(TriangleRows::entries(mesh.triangle_count()));
  std::array<std::size_t, 4> counts{};
  const int cases = std::max(share_of(60), 4);  // of which every second is cut
  for (int i = 0; i < cases; ++i) {
    const TestCamera from = camera(random, 9000, i % 2 != 0);
    const ClipTransform transform = from.transform();
    const auto light = make_light<1, Highlight::kBlinn>(from);
    Picture plain(from.width, from.height);
    Picture noted_picture(from.width, from.height);
    const DrawOptions options{two_sided};
    REQUIRE(
        ok(draw_mesh<Method>(mesh, transform, light, plain.frame, plain.depth, NoCache{}, options).status));
    const std::size_t more = 5;  // memory for further triangles stays as it is
    std::vector<TriangleSide> noted(mesh.triangle_count() + more, TriangleSide::kCut);
    std::vector<TriangleSide> found = noted;
    VertexCache<Method> cache(vertices);
    NotedSides source(cache, noted);
    REQUIRE(ok(
        draw_mesh<Method>(mesh, transform, light, noted_picture.frame, noted_picture.depth, source, options)
            .status));
    REQUIRE(ok(find_sides<Method>(mesh, transform, light, NoCache{}, found, options)));
    CHECK(noted == found);
    std::vector<TriangleSide> of_rows(noted.size(), TriangleSide::kCut);
    VertexCache<Method> with_rows(vertices, rows);
    REQUIRE(ok(find_sides<Method>(mesh, transform, light, with_rows, of_rows, options)));
    CHECK(of_rows == found);
    CHECK(plain.colours == noted_picture.colours);
    bool as_projected = true;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      as_projected = as_projected && found[t] == side_by_projection(mesh, t, transform, two_sided);
      ++counts[static_cast<std::size_t>(found[t])];
    }
    CHECK(as_projected);
    CHECK(std::all_of(found.end() - more, found.end(), [](auto s) { return s == TriangleSide::kCut; }));
  }
  CHECK(counts[static_cast<std::size_t>(TriangleSide::kFront)] > 0);
  CHECK(counts[static_cast<std::size_t>(TriangleSide::kCut)] > 0);
  CHECK((counts[static_cast<std::size_t>(TriangleSide::kBack)] > 0) == two_sided);
}

TEST_CASE("Triangle sides: a cache that holds rows of bands gives those of the whole picture") {
  Random random(47);
  const TestMesh sphere = make_sphere(9, 14, 9000, 0, random);
  const MeshView mesh = sphere.view();
  const TestCamera from = camera(random, 9000, false);
  const auto light = make_light<1, Highlight::kBlinn>(from);
  std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
  std::vector<TriangleRows> rows(TriangleRows::entries(mesh.triangle_count()));
  std::vector<TriangleSide> found(mesh.triangle_count());
  std::vector<TriangleSide> noted(mesh.triangle_count());
  REQUIRE(ok(find_sides<Method>(mesh, from.transform(), light, NoCache{}, found)));
  VertexCache<Method> cache(vertices, rows);
  NotedSides source(cache, noted);
  std::vector<std::uint16_t> memory(Frame::words(from.width, 8));
  Frame band(memory, from.width, 8, 40);
  REQUIRE(ok(draw_mesh<Method>(mesh, from.transform(), light, band, NoDepth{}, source).status));
  CHECK(noted == found);
}

TEST_CASE("Triangle sides: a cache begun with planes holds all vertices for a call without") {
  Random random(51);
  const TestMesh sphere = make_sphere(9, 14, 3000, 0, random);
  std::vector<FacePlane> planes(sphere.indices.size() / 3);
  PlaneScale scale;
  REQUIRE(ok(make_face_planes(sphere.view(), planes, scale)));
  MeshView mesh = sphere.view();
  REQUIRE(ok(mesh.attach(planes, scale)));
  const TestCamera from = camera(random, 3000, false);
  const ClipTransform transform = from.transform();
  const auto light = make_light<1, Highlight::kBlinn>(from);
  std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
  VertexCache<Method> cache(vertices);
  std::vector<TriangleSide> found(mesh.triangle_count());
  std::vector<TriangleSide> noted(mesh.triangle_count());
  REQUIRE(ok(find_sides<Method>(mesh, transform, light, cache, found)));
  REQUIRE(std::any_of(vertices.begin(), vertices.end(),
                      [](const auto& v) { return v.outcode == CachedVertex<Method>::kNotTransformed; }));
  Picture picture(from.width, from.height);
  NotedSides source(cache, noted);
  REQUIRE(ok(draw_mesh<Method, DrawFeatures{.planes = false}>(mesh, transform, light, picture.frame,
                                                              picture.depth, source)
                 .status));
  CHECK(noted == found);
}

/// A mesh whose vertices are posed: narrower than the mesh that it is made of.
struct Narrowed {
  const MeshView& wide;

  [[nodiscard]] const MeshView& view() const { return wide; }
  [[nodiscard]] ObjectPosition position(std::size_t i) const {
    ObjectPosition p = wide.position(i);
    p.x = static_cast<std::int16_t>(p.x / 3);
    return p;
  }
  [[nodiscard]] Direction direction(std::size_t i) const { return wide.direction(i); }
};

TEST_CASE("Triangle sides: those of a posed mesh are those of its vertices") {
  Random random(49);
  const TestMesh wide = make_sphere(9, 14, 9000, 0, random);
  TestMesh narrow = wide;
  const MeshView mesh = wide.view();
  const Narrowed posed{mesh};
  for (std::size_t i = 0; i < narrow.positions.size(); ++i) narrow.positions[i] = posed.position(i);
  const MeshView kept = narrow.view();
  const TestCamera from = camera(random, 9000, false);
  const ClipTransform transform = from.transform();
  const auto light = make_light<1, Highlight::kBlinn>(from);
  std::vector<TriangleSide> expected(mesh.triangle_count());
  std::vector<TriangleSide> found(mesh.triangle_count());
  std::vector<TriangleSide> noted(mesh.triangle_count());
  REQUIRE(ok(find_sides<Method>(kept, transform, light, NoCache{}, expected)));
  std::vector<CachedVertex<Method>> vertices(mesh.vertex_count());
  VertexCache<Method> cache(vertices);
  REQUIRE(ok(find_sides<Method>(posed, transform, light, cache, found)));
  CHECK(found == expected);
  Picture picture(from.width, from.height);
  NotedSides source(cache, noted);
  REQUIRE(ok(draw_mesh<Method>(posed, transform, light, picture.frame, picture.depth, source).status));
  CHECK(noted == expected);
  const VertexPositions positions(transform, std::span<const CachedVertex<Method>>(vertices));
  const VertexPositions transformed(transform);
  for (std::size_t i = 0; i < vertices.size(); ++i) CHECK(positions(mesh, i) == transformed(kept, i));
}

TEST_CASE("Triangle sides: too little memory is refused, and nothing is drawn") {
  Random random(48);
  const TestMesh sphere = make_sphere(4, 5, 9000, 0, random);
  const MeshView mesh = sphere.view();
  const TestCamera from = camera(random, 9000, false);
  const auto light = make_light<1, Highlight::kBlinn>(from);
  std::vector<TriangleSide> sides(mesh.triangle_count() - 1, TriangleSide::kBack);
  const std::vector<TriangleSide> before = sides;
  CHECK(find_sides<Method>(mesh, from.transform(), light, NoCache{}, sides) == Status::kBufferTooSmall);
  Picture picture(from.width, from.height);
  const std::vector<std::uint16_t> empty = picture.colours;
  NoCache none;
  NotedSides source(none, sides);
  CHECK(draw_mesh<Method>(mesh, from.transform(), light, picture.frame, picture.depth, source).status ==
        Status::kBufferTooSmall);
  CHECK(picture.colours == empty);
  CHECK(sides == before);
  std::vector<CachedVertex<Method>> few(3);
  std::vector<TriangleSide> enough(mesh.triangle_count());
  CHECK(find_sides<Method>(mesh, from.transform(), light, VertexCache<Method>(few), enough) ==
        Status::kCacheTooSmall);
}
