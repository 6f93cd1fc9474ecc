// SPDX-License-Identifier: MIT
// Picked triangles against pictures in which every triangle has a colour of its own.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/pick.hpp>
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/random_scene.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

Random mesh_random(4531);

/// The triangles of a mesh again, in another order and from other corners: coplanar ones that overlap.
TestMesh doubled(TestMesh mesh) {
  const std::vector<std::uint16_t> once = mesh.indices;
  for (std::size_t i = once.size(); i >= 3; i -= 3) {
    mesh.indices.insert(mesh.indices.end(), {once[i - 1], once[i - 3], once[i - 2]});
  }
  return mesh;
}

/// A square of two triangles, over another one that is cut along the other diagonal.
TestMesh make_squares() {
  TestMesh mesh;
  const Vec3 front{0, 0, 1};
  const std::uint16_t a = mesh.add({-20000, -20000, 0}, front);
  const std::uint16_t b = mesh.add({20000, -20000, 0}, front);
  const std::uint16_t c = mesh.add({20000, 20000, 0}, front);
  const std::uint16_t d = mesh.add({-20000, 20000, 0}, front);
  mesh.triangle(a, b, c);
  mesh.triangle(b, c, d);
  mesh.triangle(c, d, a);
  mesh.triangle(d, a, b);
  return mesh;
}

const TestMesh kMeshes[] = {make_sphere(5, 7, 32000, 0.1, mesh_random),
                            doubled(make_sphere(4, 6, 30000, 0, mesh_random)), make_smooth_cube(18000),
                            make_squares()};

/// Objects whose triangles each are a part with a colour of its own.
template <class Method>
struct ColouredObjects {
  MeshView views[std::size(kMeshes)];
  std::deque<PreparedMaterial<Method>> materials;
  std::deque<std::vector<Part>> parts;
  std::vector<Object> objects;

  ColouredObjects() {
    for (std::size_t i = 0; i < std::size(kMeshes); ++i) views[i] = kMeshes[i].view();
  }
  [[nodiscard]] static Rgb8 colour(std::size_t number) {
    return {static_cast<std::uint8_t>(1 + (number >> 16)), static_cast<std::uint8_t>(number >> 8),
            static_cast<std::uint8_t>(number)};
  }
  void add(Random& random) {
    const MeshView& mesh = views[random.integer(0, std::size(kMeshes) - 1)];
    const DrawOptions options{.two_sided = random.chance(0.3)};
    parts.emplace_back();
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
      materials.emplace_back(typename Method::Lighting(Unlit::lighting(colour(materials.size()))), options);
      parts.back().push_back({&materials.back(), i, 1});
    }
    objects.emplace_back(mesh, parts.back());
    place_at_random(random, objects.back(), 4);
  }
  /// The colour of what was picked.
  [[nodiscard]] Rgb8 colour_of(const Picked& picked) const {
    std::size_t number = 0;
    for (const Object* object = objects.data(); object != picked.object; ++object)
      number += object->part_count();
    REQUIRE(picked.part == picked.triangle);
    return colour(number + picked.part);
  }
};

constexpr Rgb8 kNothing{0, 0, 0};

/// Scenes of compare_pixels(). With fewer, chance alone decides how many pixels show an object.
[[nodiscard]] int scene_count() { return std::max(share_of(300), 30); }

/// Compares random pixels of pictures of random objects. Returns how many of them showed an object.
template <class Method, class Memory>
int compare_pixels(Memory& memory, unsigned seed) {
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < scene_count(); ++i) {
    ColouredObjects<Method> made;
    for (std::int32_t k = random.integer(1, 6); k > 0; --k) made.add(random);
    const Camera camera = random_camera(random);
    Canvas canvas;
    canvas.picture.clear(kNothing);
    REQUIRE(ok(draw_scene({camera, kLights, made.objects}, canvas.picture, canvas.depth, memory).status));
    for (int k = 0; k < 60; ++k) {
      const std::int32_t x = random.integer(0, Canvas::kWidth - 1);
      const std::int32_t y = random.integer(0, Canvas::kHeight - 1);
      const Picked picked = pick(memory, x, y);
      REQUIRE(picked.status == Status::kOk);
      REQUIRE(picked.depth == canvas.depth.row(y)[x]);
      REQUIRE((picked.object == nullptr ? kNothing : made.colour_of(picked)) == canvas.picture.pixel(x, y));
      hits += picked.object != nullptr ? 1 : 0;
    }
  }
  return hits;
}

}  // namespace

TEST_CASE("the picked triangle is the one whose colour is in the picture") {
  SECTION("with room for the sides of vertices") {
    static SceneMemory<SceneMethods, 12> memory;
    CHECK(compare_pixels<Unlit>(memory, 4532) > scene_count() * 2);
  }
  SECTION("without, and nothing behind the memory is read or written") {
    static struct {
      SceneMemory<MethodList<Unlit>, 12> memory;
      std::uint8_t behind[256];
    } held;
    std::fill(std::begin(held.behind), std::end(held.behind), std::uint8_t{3});  // as sides: nothing is near
    CHECK(compare_pixels<Unlit>(held.memory, 4533) > scene_count() * 2);
    for (const std::uint8_t byte : held.behind) REQUIRE(byte == 3);
  }
  SECTION("edges") {
    static SceneMemory<MethodList<SceneMethod, Unlit, Wireframe<>>, 12> memory;
    CHECK(compare_pixels<Wireframe<>>(memory, 4534) > scene_count());
  }
}

// Flat has other small triangles than the rest.
TEST_CASE("depths of shaded triangles are picked as they are drawn, whatever their size") {
  using Faces = Flat<SceneLighting>;
  constexpr auto kStone = PreparedMaterial<Faces>::of(
      matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.6)), kLights);
  static SceneMemory<MethodList<SceneMethod, Faces>, 12, 1200> memory;
  Random random(4535);
  const TestMesh ball = make_sphere(12, 20, 32000, 0, mesh_random);
  const MeshView view = ball.view();
  int hits = 0;
  for (int i = 0; i < share_of(200); ++i) {
    std::vector<Object> objects(5, random.chance(0.5) ? Object(view, kCopper) : Object(view, kStone));
    for (Object& object : objects) place_at_random(random, object, 4);
    const Camera camera = random_camera(random);
    Canvas canvas;
    REQUIRE(ok(draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory).status));
    for (int k = 0; k < 40; ++k) {
      const std::int32_t x = random.integer(0, Canvas::kWidth - 1);
      const std::int32_t y = random.integer(0, Canvas::kHeight - 1);
      const Picked picked = pick(memory, x, y);
      const std::int32_t drawn = canvas.depth.row(y)[x];
      REQUIRE((picked.object == nullptr) == (drawn == DepthBuffer::kFarthest));
      if (picked.object == nullptr) continue;
      ++hits;
      bool clipped = false;
      const TriangleIndices t = view.triangle(picked.triangle);
      for (const std::uint16_t v : {t.a, t.b, t.c})
        clipped = clipped || !camera.project(*picked.object, view.position(v)).in_front;
      REQUIRE(std::abs(picked.depth - drawn) <= (clipped ? 7 : 0));
    }
    // Nothing that is kept was changed.
    Canvas again;
    REQUIRE(ok(draw_prepared_scene(memory, again.picture, again.depth).status));
    REQUIRE(again.pixels == canvas.pixels);
  }
  CHECK(hits > share_of(200) * 2);
}

TEST_CASE("of equal depths the object is picked that is drawn first: the nearest") {
  static SceneMemory<SceneMethods, 12> memory;
  // A far triangle in the middle of the picture, where two objects have the same depth, and a near one beside
  // it, so that the middles of spheres are where they have different depths.
  TestMesh mesh;
  const Vec3 front{0, 0, 1};
  const std::uint16_t a = mesh.add({-20000, -20000, -20000}, front);
  const std::uint16_t b = mesh.add({20000, -20000, -20000}, front);
  const std::uint16_t c = mesh.add({0, 20000, -20000}, front);
  mesh.triangle(a, b, c);
  mesh.triangle(mesh.add({-30000, 30000, 20000}, front), mesh.add({-29000, 30000, 20000}, front),
                mesh.add({-30000, 31000, 20000}, front));
  const MeshView view = mesh.view();
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 6), {}},
                       Lens::field_of_view(Turn{10000}, WorldLength::of(0.02), WorldLength::of(100)), kScreen,
                       camera) == Status::kOk);
  std::vector<Object> objects(2, Object(view, kRed));
  for (Object& object : objects) object.scale = to_world(8);
  objects[1].position = WorldPoint::of(0, 0, 0.03);
  const auto depth_at = [&](const Object& object, std::int16_t z) {
    return camera.project(object, {0, 0, z}).depth;
  };
  REQUIRE(depth_at(objects[0], 0) > depth_at(objects[1], 0));
  REQUIRE(depth_at(objects[0], -20000) == depth_at(objects[1], -20000));
  REQUIRE(ok(prepare_scene({camera, kLights, objects}, memory)));
  const Picked picked = pick(memory, Canvas::kWidth / 2, Canvas::kHeight / 2);
  CHECK(picked.object == &objects[1]);
  CHECK(picked.triangle == 0);
  CHECK(picked.depth == depth_at(objects[0], -20000));
}

TEST_CASE("nothing is picked outside of the picture, before a scene or after a refused one") {
  static SceneMemory<SceneMethods, 12> memory;
  CHECK(pick(memory, 0, 0).status == Status::kNotReady);
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 1), {}}, kLens, kScreen, camera) == Status::kOk);
  const TestMesh squares = make_squares();
  const MeshView view = squares.view();
  Object object(view, kRed);
  object.scale = to_world(30);  // fills the picture
  REQUIRE(ok(prepare_scene({camera, kLights, {&object, 1}}, memory)));
  for (const std::int32_t x : {INT32_MIN, -1, 0, 95, 96, INT32_MAX}) {
    for (const std::int32_t y : {INT32_MIN, -1, 0, 71, 72, INT32_MAX}) {
      const Picked picked = pick(memory, x, y);
      CHECK(picked.status == Status::kOk);
      CHECK((picked.object == &object) == (x >= 0 && x < 96 && y >= 0 && y < 72));
    }
  }
  object.scale = {};
  REQUIRE(prepare_scene({camera, kLights, {&object, 1}}, memory) == Status::kScaleOutOfRange);
  CHECK(pick(memory, 0, 0).status == Status::kScaleOutOfRange);
  CHECK(pick(memory, 0, 0).object == nullptr);
}
