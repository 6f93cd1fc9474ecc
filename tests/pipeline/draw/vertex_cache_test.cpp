// SPDX-License-Identifier: MIT
// A picture drawn in bands with vertices kept from band to band is bit for bit the picture drawn at once, and
// a cache or slots that hold another object are refused.
#include <arcspan/draw.hpp>
#include <arcspan/draw/vertex_slots.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/mesh/make_face_planes.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <catch2/catch.hpp>
#include <tests/support/mesh_and_camera.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Light = Illumination<1, Highlight::kPhong>;
using Frame = hal::Framebuffer<Rgb565>;

/// Arc draws linear, quadratic and normalised triangles; Gouraud has other vertices.
template <class Method>
struct Object {
  TestMesh mesh;
  std::vector<FacePlane> planes;
  MeshView view;
  TestCamera camera;
  typename Method::Lighting lighting;
  std::vector<CachedVertex<Method>> vertices;
  std::vector<TriangleRows> rows;

  Object(const TestMesh& shape, const TestCamera& seen, bool with_planes)
      : mesh(shape),
        planes(mesh.indices.size() / 3),
        view(mesh.view()),
        camera(seen),
        lighting(make_light<1, Highlight::kPhong>(camera)),
        vertices(view.vertex_count()),
        rows(TriangleRows::entries(view.triangle_count())) {
    PlaneScale scale;
    REQUIRE(ok(make_face_planes(view, planes, scale)));
    if (with_planes) REQUIRE(ok(view.attach(planes, scale)));
    // Neither memory needs to be initialised.
    std::memset(static_cast<void*>(vertices.data()), 0xA5, vertices.size() * sizeof vertices[0]);
    std::memset(static_cast<void*>(rows.data()), 0xA5, rows.size() * sizeof rows[0]);
  }
};

struct Picture {
  std::vector<Frame::Word> colours;
  std::vector<std::uint16_t> depths;
  std::uint32_t most_triangles = 0;

  friend bool operator==(const Picture& a, const Picture& b) {
    return a.colours == b.colours && a.depths == b.depths;
  }
};

/// Draws a picture in bands of `rows` rows; `cache` is memory of vertices or a VertexCache.
template <class Method, class Cache>
Picture drawn(const Object<Method>& object, std::int32_t rows, Cache&& cache, bool two_sided) {
  const std::int32_t width = object.camera.width;
  const std::int32_t height = object.camera.height;
  std::vector<Frame::Word> colours(Frame::words(width, rows));
  std::vector<std::uint16_t> depths(DepthBuffer::words(width, rows));
  Frame band(colours, width, rows);
  DepthBuffer depth(depths, width, rows);
  Picture picture;
  for (std::int32_t top = 0; top < height; top += rows) {
    band.move_to(top);
    depth.move_to(top);
    band.clear({1, 2, 3});
    depth.clear();
    const DrawResult result = draw_mesh<Method>(object.view, object.camera.transform(), object.lighting, band,
                                                depth, cache, {two_sided});
    REQUIRE(ok(result.status));
    picture.most_triangles = std::max(picture.most_triangles, result.triangles);
    const std::size_t words = Frame::words(width, std::min(rows, height - top));
    picture.colours.insert(picture.colours.end(), colours.begin(),
                           colours.begin() + static_cast<std::ptrdiff_t>(words));
    picture.depths.insert(picture.depths.end(), depths.begin(),
                          depths.begin() + static_cast<std::ptrdiff_t>(words));
  }
  return picture;
}

TestCamera random_camera(Random& random) {
  TestCamera camera;
  camera.look_in_random_direction(random);
  camera.width = 90;
  camera.height = random.real(0, 1) < 0.5 ? 97 : 80;
  camera.focal = std::round(random.decades(20, 300));
  // Some are cut by the sides of the picture, the near plane or the guard band.
  camera.translation = {std::round(random.real(-3000, 3000)), std::round(random.real(-3000, 3000)),
                        -std::round(random.decades(2500, 30000))};
  return camera;
}

template <class Method>
std::span<CachedVertex<Method>> all(Object<Method>& object) {
  return object.vertices;
}

/// A source of a program's own, whose rows promise no more than that a band may skip a triangle.
struct OwnRows : NoCache {
  const TriangleRows* own_rows;
  [[nodiscard]] const TriangleRows* rows() const { return own_rows; }
};

}  // namespace

TEMPLATE_TEST_CASE("a picture in bands with kept vertices is the picture drawn at once", "", Gouraud<Light>,
                   Arc<Light>) {
  Random random(171);
  std::uint32_t triangles = 0;
  for (int round = 0; round < share_of(60); ++round) {
    const TestMesh mesh =
        round % 5 == 4 ? make_smooth_cube(2500) : make_sphere(10, 14, 3000, random.real(0, 0.3), random);
    Object<TestType> object(mesh, random_camera(random), round % 3 != 0);
    const bool two_sided = round % 4 == 3;
    const Picture whole = drawn(object, object.camera.height, all(object), two_sided);
    triangles += whole.most_triangles;
    for (const std::int32_t rows : {1, 7, 8, 24, 200}) {
      CAPTURE(round, rows, two_sided);
      VertexCache<TestType> kept(object.vertices);
      CHECK(drawn(object, rows, kept, two_sided) == whole);
      VertexCache<TestType> with_rows(object.vertices, object.rows);
      const Picture found = drawn(object, rows, with_rows, two_sided);
      CHECK(found == whole);
      CHECK(found.most_triangles <= whole.most_triangles);
      CHECK((rows < 200 || found.most_triangles == whole.most_triangles));
      CHECK(drawn(object, rows, all(object), two_sided) == whole);
      CHECK(drawn(object, rows, std::span<CachedVertex<TestType>>(), two_sided) == whole);
      VertexSlots<TestType> slots(object.rows);
      CHECK(drawn(object, rows, slots, two_sided) == whole);
      VertexSlots<TestType, 8> few;  // vertices of a triangle often share a slot
      CHECK(drawn(object, rows, few, two_sided) == whole);
      const std::vector<TriangleRows> anywhere(object.rows.size(), {0, 254});
      OwnRows own{{}, anywhere.data()};
      CHECK(drawn(object, rows, own, two_sided) == whole);
    }
  }
  CHECK(triangles > 0);
}

TEST_CASE("rows of high pictures are in groups, of which there are at most 255") {
  static_assert(TriangleRows::group_bits(1) == 0 && TriangleRows::group_bits(255) == 0);
  static_assert(TriangleRows::group_bits(256) == 1 && TriangleRows::group_bits(2048) == 4);
  using Method = Gouraud<Light>;
  Random random(176);
  for (const std::int32_t height : {255, 256, 511, 1100, 2048}) {
    TestCamera camera;
    camera.width = 20;
    camera.height = height;
    camera.focal = 1.5 * height;
    camera.translation = {0, 0, -9000};
    Object<Method> object(make_sphere(10, 14, 3000, 0.2, random), camera, false);
    const Picture whole = drawn(object, height, all(object), false);
    CHECK(whole.most_triangles > 0);
    for (const std::int32_t rows : {37, 64}) {
      CAPTURE(height, rows);
      VertexCache<Method> with_rows(object.vertices, object.rows);
      const Picture found = drawn(object, rows, with_rows, false);
      CHECK(found == whole);
      CHECK(found.most_triangles < whole.most_triangles);
    }
  }
}

TEST_CASE("slots keep the vertices of a triangle, even if all are of one slot") {
  using Method = Gouraud<Light>;
  Random random(175);
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  TestMesh mesh = make_sphere(8, 12, 3000, 0, random);
  const Object<Method> plain(mesh, camera, false);
  // Vertex i becomes vertex 8 i, and those between are far away.
  TestMesh spread = mesh;
  spread.positions.assign(8 * mesh.positions.size(), {30000, 30000, 30000});
  spread.normals.assign(8 * mesh.normals.size(), mesh.normals[0]);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    spread.positions[8 * i] = mesh.positions[i];
    spread.normals[8 * i] = mesh.normals[i];
  }
  for (auto& index : spread.indices) index = static_cast<std::uint16_t>(8 * index);
  const Object<Method> object(spread, camera, false);
  VertexSlots<Method, 8> slots;
  const Picture whole = drawn(plain, camera.height, NoCache{}, false);
  CHECK(whole.most_triangles > 0);
  CHECK(drawn(object, camera.height, slots, false) == whole);
  static_assert(VertexSource<VertexSlots<Method>, Method>);
}

TEMPLATE_TEST_CASE("bands are found by indices of 8 bits and in parts of meshes, too", "", Gouraud<Light>) {
  Random random(173);
  const auto picture = [](auto& object, std::int32_t rows) {
    return drawn(object, rows, all(object), false);
  };
  for (int round = 0; round < share_of(20); ++round) {
    TestCamera camera = random_camera(random);
    camera.translation = {0, 0, -9000};
    Object<TestType> object(make_sphere(10, 14, 3000, 0.2, random), camera, true);
    const Picture whole = picture(object, camera.height);
    CHECK(whole.most_triangles > 0);
    const std::vector<std::uint8_t> bytes(object.mesh.indices.begin(), object.mesh.indices.end());
    const MeshView wide = object.view;
    REQUIRE(ok(MeshView::make(object.mesh.positions, object.mesh.normals, bytes, object.view)));
    REQUIRE(ok(object.view.attach(object.planes, wide.plane_scale())));
    CHECK(picture(object, 8) == whole);
    for (const std::size_t count : {std::size_t{200}, std::size_t{40}, std::size_t{0}}) {
      object.view = wide.part(20, count);
      const Picture part = picture(object, camera.height);
      CHECK(picture(object, 8) == part);
      CHECK((count < 200 || part.most_triangles > 0));
    }
  }
}

TEMPLATE_TEST_CASE("a filled cache is only read", "", Gouraud<Light>, Arc<Light>) {
  Random random(172);
  for (int round = 0; round < share_of(20); ++round) {
    Object<TestType> object(make_sphere(10, 14, 3000, 0.2, random), random_camera(random), round % 2 == 0);
    const bool two_sided = round % 4 == 3;
    const Picture whole = drawn(object, object.camera.height, all(object), two_sided);
    VertexCache<TestType> cache(object.vertices, object.rows);
    REQUIRE(ok(cache.fill(object.view, object.camera.transform(), object.lighting, {two_sided})));
    const auto bytes = [&object] {
      std::vector<unsigned char> copy(object.vertices.size() * sizeof object.vertices[0]);
      std::memcpy(copy.data(), static_cast<const void*>(object.vertices.data()), copy.size());
      return copy;
    };
    const auto before = bytes();
    CAPTURE(round);
    CHECK(drawn(object, 24, cache, two_sided) == whole);
    CHECK(bytes() == before);
  }
}

TEMPLATE_TEST_CASE("a source that keeps an object refuses another until it is cleared", "",
                   VertexCache<Gouraud<Light>>, VertexSlots<Gouraud<Light>>) {
  using Method = Gouraud<Light>;
  Random random(173);
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  Object<Method> object(make_sphere(8, 12, 3000, 0, random), camera, true);
  const Object<Method> other(make_sphere(8, 12, 3000, 0, random), camera, true);
  TestType cache = [&] {
    if constexpr (std::is_same_v<TestType, VertexCache<Method>>) {
      return TestType(object.vertices, object.rows);
    } else {
      return TestType(object.rows);
    }
  }();
  std::vector<Frame::Word> colours(Frame::words(camera.width, camera.height));
  Frame frame(colours, camera.width, camera.height);
  frame.clear({1, 2, 3});
  const std::vector<Frame::Word> blank = colours;
  const auto draw = [&](const MeshView& mesh, const TestCamera& seen, const DrawOptions& options) {
    return draw_mesh<Method>(mesh, seen.transform(), object.lighting, frame, NoDepth{}, cache, options)
        .status;
  };
  CHECK(draw(object.view, camera, {}) == Status::kOk);
  CHECK(colours != blank);
  frame.clear({1, 2, 3});

  TestCamera moved = camera;
  moved.translation.x += 1;
  MeshView without_planes = object.mesh.view();
  CHECK(draw(other.view, camera, {}) == Status::kCacheMismatch);
  CHECK(draw(without_planes, camera, {}) == Status::kCacheMismatch);
  CHECK(draw(object.view, moved, {}) == Status::kCacheMismatch);
  CHECK(draw(object.view, camera, {.two_sided = true}) == Status::kCacheMismatch);
  CHECK(colours == blank);
  CHECK(draw(object.view, camera, {}) == Status::kOk);
  CHECK(colours != blank);
  cache.clear();
  CHECK(draw(object.view, moved, {.two_sided = true}) == Status::kOk);
}

TEST_CASE("a vertex cache refuses memory that is too small") {
  using Method = Gouraud<Light>;
  Random random(174);
  TestCamera camera;
  camera.translation = {0, 0, -9000};
  Object<Method> object(make_sphere(8, 12, 3000, 0, random), camera, true);
  const ClipTransform transform = camera.transform();
  std::vector<Frame::Word> colours(Frame::words(camera.width, camera.height));
  Frame frame(colours, camera.width, camera.height);
  const std::vector<Frame::Word> blank = colours;
  const auto refuses = [&](VertexCache<Method> cache) {
    CHECK(cache.fill(object.view, transform, object.lighting) == Status::kCacheTooSmall);
    CHECK(draw_mesh<Method>(object.view, transform, object.lighting, frame, NoDepth{}, cache).status ==
          Status::kCacheTooSmall);
    CHECK(colours == blank);
  };
  const std::span<CachedVertex<Method>> vertices(object.vertices);
  const std::span<TriangleRows> rows(object.rows);
  refuses(VertexCache<Method>({}));
  refuses(VertexCache<Method>(vertices.first(vertices.size() - 1)));
  refuses(VertexCache<Method>(vertices.first(vertices.size() - 1), rows));
  refuses(VertexCache<Method>(vertices, rows.first(rows.size() - 1)));
  VertexSlots<Method> slots(rows.first(rows.size() - 1));
  CHECK(draw_mesh<Method>(object.view, transform, object.lighting, frame, NoDepth{}, slots).status ==
        Status::kCacheTooSmall);
  CHECK(colours == blank);
}
