// SPDX-License-Identifier: MIT
// The rectangle of a scene against its pixels and its vertices.
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/drawn_rect.hpp>
#include <arcspan/mesh/make_face_planes.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/random_scene.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using Methods = MethodList<SceneMethod, Unlit, Wireframe<>>;

Random mesh_random(4521);
TestMesh moved_ball = make_sphere(8, 12, 32000, 0, mesh_random);
const TestMesh kBall = moved_ball;
const TestMesh kCube = make_smooth_cube(18000);
const MeshView kBallView = kBall.view();
const MeshView kCubeView = kCube.view();

constexpr PreparedMaterial<Unlit> kBothSides{Unlit::lighting({90, 90, 90}), {.two_sided = true}};
constexpr PreparedMaterial<Wireframe<>> kWire{Wireframe<>::Lighting(Unlit::lighting({0, 99, 0}))};
constexpr PreparedMaterial<Wireframe<>> kWholeWire{Wireframe<>::Lighting(Unlit::lighting({0, 99, 0})),
                                                   {.two_sided = true}};
constexpr Part kParts[] = {{&kCopper, 0, 5}, {&kWire, 5, 3}, {&kBothSides, 8, 4}};

SceneMemory<Methods, 12> without_vertices;
SceneMemory<Methods, 12, 100> shared_vertices;
SceneMemory<Methods, 12, 1200> kept_vertices;

/// The ball with its planes.
struct Planed {
  std::vector<FacePlane> planes;
  MeshView view = kBallView;
  Planed() : planes(kBallView.triangle_count()) {
    PlaneScale scale;
    REQUIRE(ok(make_face_planes(kBallView, planes, scale)));
    REQUIRE(ok(view.attach(planes, scale)));
  }
};

RandomObjects random_objects(Random& random, const MeshView& planed, std::size_t count) {
  RandomObjects made{random_camera(random), {}};
  const SceneMaterial* const materials[] = {&kCopper, &kRed, &kBothSides, &kWire, &kWholeWire};
  for (std::size_t i = 0; i < count; ++i) {
    const SceneMaterial& material = *materials[random.integer(0, 4)];
    switch (random.integer(0, 3)) {
      case 0:
        made.objects.emplace_back(planed, material);
        break;
      case 1:
        made.objects.emplace_back(kBallView, material);
        break;
      case 2:
        made.objects.emplace_back(kCubeView, material);
        break;
      default:
        made.objects.emplace_back(kCubeView, kParts);
    }
    place_at_random(random, made.objects.back(), 7);
  }
  return made;
}

/// The rectangle around the pixels of a canvas that were drawn.
Rect drawn_pixels(const Canvas& canvas) {
  Rect rect{};
  for (std::int32_t y = 0; y < Canvas::kHeight; ++y) {
    for (std::int32_t x = 0; x < Canvas::kWidth; ++x) {
      if (canvas.depth.row(y)[x] != DepthBuffer::kFarthest) rect = bounding_rect(rect, {x, y, x + 1, y + 1});
    }
  }
  return rect;
}

std::int32_t farthest_side(const Rect& a, const Rect& b) {
  return std::max({std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right),
                   std::abs(a.bottom - b.bottom)});
}

/// Draws the prepared scene, and checks that its rectangle before holds all pixels.
template <class Memory>
Rect check_scene(const RandomObjects& made, Memory& memory, const Canvas& expected) {
  REQUIRE(ok(prepare_scene(made.scene(), memory)));
  const Rect rect = drawn_rect(memory);
  Canvas canvas;
  REQUIRE(ok(draw_prepared_scene(memory, canvas.picture, canvas.depth).status));
  REQUIRE(canvas.pixels == expected.pixels);
  REQUIRE(canvas.depths == expected.depths);
  const Rect pixels = drawn_pixels(canvas);
  REQUIRE(bounding_rect(rect, pixels) == rect);
  REQUIRE(bounding_rect(rect, {0, 0, Canvas::kWidth, Canvas::kHeight}) ==
          Rect{0, 0, Canvas::kWidth, Canvas::kHeight});
  return rect;
}

}  // namespace

TEST_CASE("all pixels of a scene lie in its rectangle, and asking for it changes none") {
  const Planed planed;
  Random random(4522);
  int part_of_picture = 0;
  for (int i = 0; i < share_of(600); ++i) {
    const RandomObjects made =
        random_objects(random, planed.view, static_cast<std::size_t>(random.integer(1, 5)));
    Canvas expected;
    REQUIRE(ok(draw_scene(made.scene(), expected.picture, expected.depth, without_vertices).status));
    const Rect rect = check_scene(made, without_vertices, expected);
    CHECK(check_scene(made, shared_vertices, expected) == rect);
    CHECK(check_scene(made, kept_vertices, expected) == rect);
    Rect objects{};
    for (const Object& object : made.objects)
      objects = bounding_rect(objects, drawn_rect(kept_vertices, object));
    CHECK(objects == rect);
    part_of_picture += !rect.empty() && rect.width() < Canvas::kWidth / 2 ? 1 : 0;
  }
  CHECK(part_of_picture > share_of(600) / 10);
}

TEST_CASE("the rectangle of an unclipped object is that of its vertices, and touches its pixels") {
  const Planed planed;
  Random random(4523);
  int tight = 0;
  for (int i = 0; i < share_of(600); ++i) {
    RandomObjects made{random_camera(random), {}};
    const bool two_sided = random.chance(0.5);
    made.objects.emplace_back(random.chance(0.5) ? planed.view : kBallView,
                              two_sided ? static_cast<const SceneMaterial&>(kBothSides) : kRed);
    place_at_random(random, made.objects[0], 3);
    std::int32_t sides[4] = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    bool whole = true;
    for (const ObjectPosition& p : kBall.positions) {
      const ScreenPoint seen = made.camera.project(made.objects[0], p);
      whole = whole && seen.in_picture;
      sides[0] = std::min(sides[0], seen.x.raw());
      sides[1] = std::min(sides[1], seen.y.raw());
      sides[2] = std::max(sides[2], seen.x.raw());
      sides[3] = std::max(sides[3], seen.y.raw());
    }
    if (!whole) continue;
    REQUIRE(ok(prepare_scene(made.scene(), kept_vertices)));
    const Rect rect = drawn_rect(kept_vertices);
    const auto pixel = [](std::int32_t v) { return (v + 7) >> 4; };  // the first centre at or behind v
    const Rect exact{pixel(sides[0]), pixel(sides[1]), pixel(sides[2]), pixel(sides[3])};
    // A closed mesh has its outline in common with its front faces.
    if (two_sided) CHECK(rect == (exact.empty() ? Rect{} : exact));
    CHECK((rect.empty() || bounding_rect(rect, exact) == exact));
    Canvas canvas;
    REQUIRE(ok(draw_prepared_scene(kept_vertices, canvas.picture, canvas.depth).status));
    const Rect pixels = drawn_pixels(canvas);
    if (rect.width() < 8 || rect.height() < 8) continue;
    ++tight;
    CHECK(farthest_side(rect, pixels) <= 1);
  }
  CHECK(tight > share_of(600) / 20);
}

TEST_CASE("all pixels of an object that clip planes cut lie in its rectangle") {
  Random random(4524);
  const SceneMaterial* const materials[] = {&kBothSides, &kRed, &kWire};
  int part_of_picture = 0;
  for (int i = 0; i < 60; ++i) {
    RandomObjects made{random_camera(random), {}};
    made.objects.emplace_back(kCubeView, *materials[i % 3]);
    place_beside_eye(random, made.objects[0], made.camera, 1.1);
    Canvas expected;
    REQUIRE(ok(draw_scene(made.scene(), expected.picture, expected.depth, without_vertices).status));
    const Rect rect = check_scene(made, without_vertices, expected);
    part_of_picture += !rect.empty() && rect.width() < Canvas::kWidth ? 1 : 0;
  }
  CHECK(part_of_picture > 3);
}

TEST_CASE("a triangle beside the picture does not count") {
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 3), {}}, kLens, kScreen, camera) == Status::kOk);
  constexpr std::int16_t kFar = 32000;
  TestMesh mesh;
  mesh.positions = {{0, 0, 0}, {3000, 0, 0}, {0, 3000, 0}};
  for (const std::int16_t x : {kFar, static_cast<std::int16_t>(-kFar)}) {
    mesh.positions.push_back({x, -kFar, 0});
    mesh.positions.push_back({static_cast<std::int16_t>(x - x / 8), 0, 0});
    mesh.positions.push_back({x, kFar, 0});
  }
  for (const std::int16_t y : {kFar, static_cast<std::int16_t>(-kFar)}) {
    mesh.positions.push_back({-kFar, y, 0});
    mesh.positions.push_back({0, static_cast<std::int16_t>(y - y / 8), 0});
    mesh.positions.push_back({kFar, y, 0});
  }
  mesh.normals.assign(mesh.positions.size(), pack_normal(0, 0, 1));
  const auto in_view = [&](std::size_t triangles) {
    mesh.indices.clear();
    for (std::size_t i = 0; i < 3 * triangles; ++i) mesh.indices.push_back(static_cast<std::uint16_t>(i));
    const MeshView view = mesh.view();
    Object object(view, kBothSides);
    object.scale = WorldLength::of(6);
    const Object objects[] = {object};
    REQUIRE(ok(prepare_scene({camera, kLights, objects}, kept_vertices)));
    return drawn_rect(kept_vertices);
  };
  const Rect one = in_view(1);
  CHECK(one.width() > 3);
  CHECK(one.width() < Canvas::kWidth / 2);
  CHECK(in_view(5) == one);
}

TEST_CASE("vertices that the rectangle needed are not transformed again") {
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 1, 3), {}}, kLens, kScreen, camera) == Status::kOk);
  const MeshView moved = moved_ball.view();
  const Object objects[] = {Object(moved, kCopper), Object(moved, kRed, WorldPoint::of(0.5, 0.5, -1))};
  const Scene scene{camera, kLights, objects};
  Canvas expected;
  REQUIRE(ok(draw_scene(scene, expected.picture, expected.depth, kept_vertices).status));
  REQUIRE(ok(prepare_scene(scene, kept_vertices)));
  REQUIRE_FALSE(drawn_rect(kept_vertices).empty());
  const std::vector<ObjectPosition> positions = moved_ball.positions;
  for (ObjectPosition& p : moved_ball.positions) p = {};  // a vertex that is transformed now is elsewhere
  Canvas canvas;
  REQUIRE(ok(draw_prepared_scene(kept_vertices, canvas.picture, canvas.depth).status));
  std::copy(positions.begin(), positions.end(), moved_ball.positions.begin());
  CHECK(canvas.pixels == expected.pixels);
  CHECK(canvas.depths == expected.depths);
}

TEST_CASE("there is no rectangle where nothing is drawn") {
  static SceneMemory<Methods, 2> fresh;
  CHECK(drawn_rect(fresh) == Rect{});
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(0, 0, 3), {}}, kLens, kScreen, camera) == Status::kOk);
  // A triangle that shows its back; the mesh is one-sided.
  TestMesh single;
  const std::uint16_t corners[] = {single.add({-9000, -9000, 0}, {0, 0, 1}),
                                   single.add({9000, -9000, 0}, {0, 0, 1}),
                                   single.add({0, 9000, 0}, {0, 0, 1})};
  single.triangle(corners[0], corners[2], corners[1]);
  const MeshView back = single.view();
  const Object one_sided(back, kRed);
  REQUIRE(ok(prepare_scene({camera, kLights, {&one_sided, 1}}, fresh)));
  CHECK(drawn_rect(fresh) == Rect{});
  const Object two_sided(back, kBothSides);
  REQUIRE(ok(prepare_scene({camera, kLights, {&two_sided, 1}}, fresh)));
  CHECK_FALSE(drawn_rect(fresh).empty());
  CHECK(drawn_rect(fresh, two_sided) == drawn_rect(fresh));
  CHECK(drawn_rect(fresh, one_sided) == Rect{});  // not of this scene
  Object refused = two_sided;
  refused.scale = {};
  REQUIRE(prepare_scene({camera, kLights, {&refused, 1}}, fresh) == Status::kScaleOutOfRange);
  CHECK(drawn_rect(fresh) == Rect{});
}

TEST_CASE("a rectangle around two contains both, and an empty one has no place") {
  CHECK(bounding_rect({1, 2, 3, 4}, {5, 0, 6, 3}) == Rect{1, 0, 6, 4});
  CHECK(bounding_rect({1, 2, 3, 4}, {9, 9, 9, 20}) == Rect{1, 2, 3, 4});
  CHECK(bounding_rect({9, 9, 9, 20}, {1, 2, 3, 4}) == Rect{1, 2, 3, 4});
  CHECK(bounding_rect({9, 9, 9, 20}, {4, 4, 3, 9}) == Rect{});
}
