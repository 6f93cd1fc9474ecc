// SPDX-License-Identifier: MIT
// Wireframes: the edges of the faces that are seen, by every way of draw_mesh() alike.
#include <arcspan/draw.hpp>
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::int32_t kWidth = 97;
constexpr std::int32_t kHeight = 61;
constexpr std::size_t kPixels = static_cast<std::size_t>(kWidth * kHeight);
using Glassy = WithOperation<Unlit, Opacity<>>;
using Wires = Wireframe<Glassy>;

struct Scene {
  TestMesh mesh;
  TestCamera camera;
};

/// A sphere in view, one cut by the near plane, the inside of one, a cube cut by the guard band, and many
/// small triangles.
std::vector<Scene> scenes() {
  Random random(78);
  TestCamera camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.focal = 80;
  std::vector<Scene> list;
  camera.look_in_random_direction(random);
  camera.translation = {0, 0, -12000};
  list.push_back({make_sphere(8, 12, 3000, 0.2, random), camera});
  camera.translation = {900, 300, -3100};
  list.push_back({make_sphere(5, 8, 3000, 0, random), camera});
  camera.translation = {100, -50, 200};
  list.push_back({make_sphere(4, 6, 3000, 0, random).inside_out(), camera});
  TestCamera close = camera;
  close.right = {1, 0, 0};
  close.up = {0, 1, 0};
  close.back = {0, 0, 1};
  close.focal = 1200;
  close.translation = {-2500, -500, -3100};  // an edge leads through the middle of the picture
  list.push_back({make_smooth_cube(2500), close});
  camera.translation = {0, 0, -12000};
  TestMesh small;
  for (std::uint16_t i = 0; i < 300; i = static_cast<std::uint16_t>(i + 3)) {
    const Vec3 middle = 5000.0 * random_unit(random);
    for (int corner = 0; corner < 3; ++corner) small.add(middle + 300.0 * random_unit(random), {0, 0, 1});
    small.triangle(i, static_cast<std::uint16_t>(i + 1), static_cast<std::uint16_t>(i + 2));
  }
  list.push_back({small, camera});
  return list;
}

struct Picture {
  std::vector<std::uint8_t> pixels;
  std::vector<std::uint16_t> depths;
  std::uint32_t triangles = 0;
  friend bool operator==(const Picture& a, const Picture& b) {
    return a.pixels == b.pixels && a.depths == b.depths;
  }
};

enum class Cache { kNone, kPlain, kBand, kBandWithRows };

/// The wireframe, half opaque on black, in bands.
Picture drawn(const MeshView& mesh, const ClipTransform& transform, std::int32_t rows, Cache kind,
              bool two_sided) {
  const Wires::Lighting white(Glassy::Lighting(Unlit::lighting({255, 255, 255}), Opacity<>{16}));
  std::vector<CachedVertex<Wires>> vertices(kind == Cache::kNone ? 0 : mesh.vertex_count());
  std::vector<TriangleRows> triangle_rows(
      kind == Cache::kBandWithRows ? TriangleRows::entries(mesh.triangle_count()) : 0);
  VertexCache<Wires> kept(vertices, triangle_rows);
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(kWidth * rows));
  std::vector<std::uint16_t> depths(memory.size());
  hal::Framebuffer<Gray8> band(memory, kWidth, rows);
  DepthBuffer depth(depths, kWidth, rows);
  Picture picture;
  for (std::int32_t first = 0; first < kHeight; first += rows) {
    band.move_to(first);
    band.clear({});
    depth.move_to(first);
    depth.clear();
    const DrawOptions options{two_sided};
    const DrawResult result =
        kind == Cache::kNone || kind == Cache::kPlain
            ? draw_mesh<Wires>(mesh, transform, white, band, depth, std::span(vertices), options)
            : draw_mesh<Wires>(mesh, transform, white, band, depth, kept, options);
    REQUIRE(ok(result.status));
    picture.triangles += result.triangles;
    picture.pixels.insert(picture.pixels.end(), memory.begin(), memory.end());
    picture.depths.insert(picture.depths.end(), depths.begin(), depths.end());
  }
  picture.pixels.resize(kPixels);
  picture.depths.resize(kPixels);
  return picture;
}

/// True if a triangle shows its front to the eye, in double precision.
bool shows_front(const Scene& scene, const MeshView& mesh, const TriangleIndices& t) {
  const auto at = [&](std::uint16_t i) {
    const ObjectPosition& p = mesh.position(i);
    return scene.camera.to_view({double(p.x), double(p.y), double(p.z)});
  };
  return dot(cross(at(t.b) - at(t.a), at(t.c) - at(t.a)), at(t.a)) < 0;
}

}  // namespace

TEST_CASE("a wireframe consists of the edges of the faces that are seen") {
  int number = 0;
  for (const Scene& scene : scenes()) {
    const MeshView mesh = scene.mesh.view();
    const ClipTransform transform = scene.camera.transform();
    for (const bool two_sided : {false, true}) {
      INFO("scene " << number << ", two-sided " << two_sided);
      std::vector<ObjectLine> edges;
      for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
        const TriangleIndices t = mesh.triangle(i);
        if (!two_sided && !shows_front(scene, mesh, t)) continue;
        edges.push_back({mesh.position(t.a), mesh.position(t.b)});
        edges.push_back({mesh.position(t.b), mesh.position(t.c)});
        edges.push_back({mesh.position(t.c), mesh.position(t.a)});
      }
      Picture lines{std::vector<std::uint8_t>(kPixels), std::vector<std::uint16_t>(kPixels)};
      hal::Framebuffer<Gray8> frame(lines.pixels, kWidth, kHeight);
      DepthBuffer depth(lines.depths, kWidth, kHeight);
      depth.clear();
      const Glassy::Lighting white(Unlit::lighting({255, 255, 255}), Opacity<>{16});
      REQUIRE(ok(draw_lines<Glassy>(edges, transform, white, frame, depth, DepthBias{})));
      const Picture wires = drawn(mesh, transform, kHeight, Cache::kNone, two_sided);
      CHECK(wires == lines);
      CHECK(std::count(wires.pixels.begin(), wires.pixels.end(), 0) < 5900);
    }
    ++number;
  }
}

TEST_CASE("an edge of two faces is blended once") {
  // Two faces of a square, whose common edge meets no other line between its ends.
  TestMesh square;
  for (const Vec3 corner : {Vec3{-2000, -2000, 0}, {2000, -2000, 300}, {2000, 2000, 0}, {-2000, 2000, 900}}) {
    square.add(corner, {0, 0, 1});
  }
  square.triangle(0, 1, 2);
  square.triangle(0, 2, 3);
  TestCamera camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.focal = 80;
  camera.translation = {0, 0, -8000};
  const Picture picture = drawn(square.view(), camera.transform(), kHeight, Cache::kNone, false);
  CHECK(std::count(picture.pixels.begin(), picture.pixels.end(), 128) > 150);
  CHECK(std::count_if(picture.pixels.begin(), picture.pixels.end(), [](auto v) { return v > 128; }) <= 4);
}

TEST_CASE("bands, caches and planes change no pixel of a wireframe") {
  int number = 0;
  for (const Scene& scene : scenes()) {
    MeshView mesh = scene.mesh.view();
    const ClipTransform transform = scene.camera.transform();
    std::vector<FacePlane> planes(mesh.triangle_count());
    PlaneScale scale;
    for (const bool two_sided : {false, true}) {
      const Picture whole = drawn(mesh, transform, kHeight, Cache::kNone, two_sided);
      for (const bool with_planes : {false, true}) {
        MeshView planed = mesh;
        if (with_planes) {
          REQUIRE(ok(make_face_planes(mesh, planes, scale)));
          REQUIRE(ok(planed.attach(planes, scale)));
        }
        for (const Cache cache : {Cache::kNone, Cache::kPlain, Cache::kBand, Cache::kBandWithRows}) {
          for (std::int32_t rows = 1; rows <= kHeight; rows += 300 / share_of(100)) {
            INFO("scene " << number << ", " << rows << " rows, cache " << static_cast<int>(cache)
                          << ", planes " << with_planes << ", two-sided " << two_sided);
            const Picture picture = drawn(planed, transform, rows, cache, two_sided);
            REQUIRE(picture == whole);
            if (rows == kHeight) CHECK(picture.triangles == whole.triangles);
          }
        }
      }
    }
    ++number;
  }
}
