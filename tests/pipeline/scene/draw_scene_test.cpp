// SPDX-License-Identifier: MIT
// Scenes against draw_mesh(), bands against whole pictures, culling and order.
#include <arcspan/shading/gouraud.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

// prepare_scene() would keep a reference to it.
static_assert(std::is_constructible_v<Scene, const Camera&, LightList, std::span<const Object>>);
static_assert(!std::is_constructible_v<Scene, Camera, LightList, std::span<const Object>>);

Random mesh_random(1821);
const TestMesh kBall = make_sphere(8, 12, 32000, 0, mesh_random);
const TestMesh kCube = make_smooth_cube(18000);
const MeshView kBallView = kBall.view();
const MeshView kCubeView = kCube.view();

// The first has room for the vertices of one object, the second for those of all, and for the rows of some.
SceneMemory<SceneMethods, 12, 100> memory_of_scene;
SceneMemory<SceneMethods, 12, 1200, 500> large_memory;

bool equal(const Picture& a, const Picture& b) {
  for (std::int32_t y = a.bounds().top; y < a.bounds().bottom; ++y) {
    for (std::int32_t x = 0; x < Canvas::kWidth; ++x) {
      if (a.pixel(x, y) != b.pixel(x, y)) return false;
    }
  }
  return true;
}

/// Draws all visible objects in the order of their list, with nothing culled and without vertex caches.
void draw_unculled(const Scene& scene, Canvas& canvas) {
  for (const Object& object : scene.objects) {
    ClipTransform transform;
    REQUIRE(scene.camera.place(object.position, object.rotation, object.scale, transform));
    detail::SceneHeader header;
    header.lights = scene.lights;
    header.camera = &scene.camera;
    const detail::ObjectLights lights = detail::lights_at(header, object);
    for (std::size_t i = 0; i < object.part_count(); ++i) {
      const Part part = object.part(i);
      const MeshView mesh = object.mesh().part(part.first, part.count);
      if (part.material->use() == kRed.use()) {
        REQUIRE(ok(draw_mesh<Unlit>(mesh, transform, kRed.lighting(), canvas.picture, canvas.depth).status));
      } else {
        SceneLighting lighting;
        const auto& material = *static_cast<const PreparedMaterial<SceneMethod>*>(part.material);
        REQUIRE(ok(material.light(lights, lighting)));
        REQUIRE(ok(draw_mesh<SceneMethod>(mesh, transform, lighting, canvas.picture, canvas.depth, {},
                                          material.options())
                       .status));
      }
    }
  }
}

Camera looking(Vec3 eye, Vec3 target, const Lens& lens = kLens) {
  Camera camera;
  REQUIRE(Camera::make({to_point(eye), to_point(target)}, lens, kScreen, camera) == Status::kOk);
  return camera;
}

struct RandomScene {
  Camera camera;
  std::vector<Object> objects;
  [[nodiscard]] Scene scene() const { return {camera, kLights, objects}; }
};

RandomScene random_scene(Random& random) {
  const auto point = [&](double size) {
    return Vec3{random.real(-size, size), random.real(-size, size), random.real(-size, size)};
  };
  const Lens lens = random.chance(0.3) ? Lens::orthographic(to_world(6), to_world(0.5), to_world(30)) : kLens;
  RandomScene made{looking(point(8), point(2), lens), {}};
  static const Part kParts[] = {{&kCopper, 0, 5}, {&kRed, 5, 3}, {&kJade, 8, 4}};
  for (int i = 0; i < 10; ++i) {
    if (random.chance(0.5)) {
      made.objects.emplace_back(kBallView, random.chance(0.5) ? kCopper : kJade);
    } else {
      made.objects.emplace_back(kCubeView, kParts);
    }
    Object& object = made.objects.back();
    object.position = to_point(point(7));
    object.scale = to_world(random.decades(0.05, 2));
    object.rotation = random_rotation(random);
  }
  return made;
}

}  // namespace

TEST_CASE("a scene of one object is draw_mesh with the transform made by hand") {
  const Rotation turn = rotation_of(EulerAngles{{3000}, {5000}, {700}});
  Object object(kBallView, kCopper);
  object.rotation = turn;
  object.position = WorldPoint::of(0.5, -0.25, -4);
  object.scale = WorldLength::of(0.5);
  // One light, directional: two would be seen from the sphere's middle.
  static constexpr SceneLight kSun[] = {SceneLight::directional(arcspan::normalised(3, 4, 5))};
  static constexpr LightList kDay{kSun};
  static constexpr auto kMaterial = PreparedMaterial<SceneMethod>::of(
      matter(Coefficient::of(0.8), Coefficient::of(0.4), Coefficient::of(0.2)), kDay);
  Object lit(kBallView, kMaterial);
  lit.rotation = turn;
  lit.position = object.position;
  lit.scale = object.scale;
  const Camera camera = [] {
    Camera made;
    REQUIRE(Camera::make({{}, WorldPoint::of(0, 0, -1)},
                         Lens::focal_length(PixelLength::of(100), WorldLength::of(1), WorldLength::of(9)),
                         kScreen, made) == Status::kOk);
    return made;
  }();
  Canvas by_scene;
  const SceneResult result =
      draw_scene({camera, kDay, {&lit, 1}}, by_scene.picture, by_scene.depth, memory_of_scene);
  REQUIRE(result.status == Status::kOk);
  CHECK(result.objects == 1);
  CHECK(result.triangles > 50);

  // 32768 units are half a world unit, so that a world unit is 65536 object units.
  const Placement placement{turn,
                            {ObjectLength::of(32768), ObjectLength::of(-16384), ObjectLength::of(-262144)}};
  ClipTransform transform;
  REQUIRE(ClipTransform::make(placement,
                              {PixelLength::of(100), ObjectLength::of(65536), ObjectLength::of(589824)},
                              kScreen, transform) == Status::kOk);
  SceneLighting lighting;
  const DirectionalLight off{Direction{}, Coefficient{}};
  REQUIRE(SceneLighting::make(matter(Coefficient::of(0.8), Coefficient::of(0.4), Coefficient::of(0.2)),
                              {DirectionalLight{turn.to_object(arcspan::normalised(3, 4, 5))}, off},
                              turn.to_object(arcspan::normalised(0, 0, 1)), lighting) == Status::kOk);
  Canvas by_hand;
  const DrawResult drawn =
      draw_mesh<SceneMethod>(kBallView, transform, lighting, by_hand.picture, by_hand.depth);
  CHECK(drawn.triangles == result.triangles);
  CHECK(by_scene.pixels == by_hand.pixels);
  CHECK(by_scene.depths == by_hand.depths);
}

TEST_CASE("culling and order change no pixel, and bands are the whole picture") {
  Random random(1822);
  std::size_t drawn = 0;
  std::size_t all = 0;
  for (int i = 0; i < share_of(300); ++i) {
    const RandomScene made = random_scene(random);
    // Drawn in the scene's own order, so that equal depths of two objects meet in the same order.
    Canvas canvas;
    const SceneResult result = draw_scene(made.scene(), canvas.picture, canvas.depth, memory_of_scene);
    REQUIRE(result.status == Status::kOk);
    std::vector<Object> sorted;
    const detail::SceneFrame frame = memory_of_scene.frame();
    std::vector<bool> used(made.objects.size());
    for (std::size_t k = 0; k < frame.header.in_view; ++k) {
      const Object* const object = frame.entries[frame.order[k]].object;
      used[static_cast<std::size_t>(object - made.objects.data())] = true;
      sorted.push_back(*object);
    }
    for (std::size_t k = 0; k < used.size(); ++k) {
      if (!used[k]) sorted.push_back(made.objects[k]);
    }
    drawn += result.objects;
    all += sorted.size();
    Canvas unculled;
    draw_unculled({made.camera, kLights, sorted}, unculled);
    REQUIRE(equal(canvas.picture, unculled.picture));

    constexpr std::int32_t kRows = 10;  // the last band reaches beyond the picture
    Canvas band(kRows);
    REQUIRE(ok(prepare_scene(made.scene(), large_memory)));
    CHECK(large_memory.frame().header.keeps_vertices);
    for (std::int32_t row = 0; row < Canvas::kHeight; row += kRows) {
      band.move_to(row);
      REQUIRE(ok(draw_prepared_scene(large_memory, band.picture, band.depth).status));
      for (std::int32_t y = row; y < std::min(row + kRows, Canvas::kHeight); ++y) {
        for (std::int32_t x = 0; x < Canvas::kWidth; ++x) {
          REQUIRE(band.picture.pixel(x, y) == canvas.picture.pixel(x, y));
        }
      }
    }
  }
  // Both happen often.
  CHECK(drawn > all / 10);
  CHECK(drawn < all * 9 / 10);
}

TEST_CASE("the nearest object is drawn first with depth, the farthest without") {
  std::vector<Object> objects;
  for (const double z : {-2.0, -9.0, 0.0, -4.0}) {
    objects.emplace_back(kBallView, kRed);
    objects.back().position = to_point({0, 0, z});
    objects.back().scale = to_world(0.4);
  }
  const Camera camera = looking({0, 0, 3}, {});
  Canvas canvas;
  REQUIRE(ok(draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory_of_scene).status));
  const detail::SceneFrame frame = memory_of_scene.frame();
  REQUIRE(frame.header.in_view == 4);
  const std::size_t expected[] = {2, 0, 3, 1};
  for (std::size_t i = 0; i < 4; ++i) CHECK(frame.entries[frame.order[i]].object == &objects[expected[i]]);

  // Spheres that do not overlap look the same without depth.
  for (Object& object : objects) {
    object = Object(kBallView, kJade);
    object.scale = to_world(0.9);
  }
  for (std::size_t i = 0; i < 4; ++i) objects[i].position = to_point({0.3 * double(i), 0, -2.0 * double(i)});
  std::swap(objects[0], objects[2]);
  Canvas with;
  Canvas without;
  REQUIRE(ok(draw_scene({camera, kLights, objects}, with.picture, with.depth, memory_of_scene).status));
  REQUIRE(ok(draw_scene({camera, kLights, objects}, without.picture, NoDepth{}, memory_of_scene).status));
  CHECK(with.pixels == without.pixels);
}

TEST_CASE("objects are ordered where steps of depth do not tell them apart") {
  // Middles beyond the far plane at 100, before the near one at 0.5, and farther than half the far plane, of
  // objects of different scale.
  for (const double nearest : {100.5, -6.0, 60.0}) {
    const double apart = nearest == 60.0 ? 0.05 : 2;
    for (const bool listed_first : {false, true}) {
      std::vector<Object> objects;
      for (const bool far : {listed_first, !listed_first}) {
        objects.emplace_back(kBallView, kRed);
        objects.back().position = to_point({0, 0, -nearest - (far ? apart : 0.0)});
        objects.back().scale = to_world(far ? 8 : 12);
      }
      const Camera camera = looking({0, 0, 0}, {0, 0, -1});
      REQUIRE(ok(prepare_scene({camera, kLights, objects}, memory_of_scene)));
      const detail::SceneFrame frame = memory_of_scene.frame();
      REQUIRE(frame.header.in_view == 2);
      CAPTURE(nearest, listed_first);
      CHECK(frame.entries[frame.order[0]].object == &objects[listed_first ? 1 : 0]);
    }
  }
}

TEST_CASE("objects with the same middle are in the order of the scene, whatever their scale") {
  for (int step = 0; step < 200; ++step) {
    std::vector<Object> objects;
    for (const int number : {0, 1}) {
      objects.emplace_back(kBallView, kRed);
      objects.back().scale = to_world((step + number) % 2 == 0 ? 1 : 1.1);
    }
    const Camera camera = looking({0.3, 0.2, 3 + 0.01 * step}, {0, 0, 0});
    REQUIRE(ok(prepare_scene({camera, kLights, objects}, memory_of_scene)));
    const detail::SceneFrame frame = memory_of_scene.frame();
    REQUIRE(frame.header.in_view == 2);
    CAPTURE(step);
    CHECK(frame.entries[frame.order[0]].object == objects.data());
  }
}

TEST_CASE("invisible objects and objects behind the camera are not drawn") {
  std::vector<Object> objects(3, Object(kBallView, kRed));
  objects[0].visible = false;
  objects[1].position = WorldPoint::of(0, 0, 9);
  objects[2].position = WorldPoint::of(-300, 0, -90);
  const Camera camera = looking({0, 0, 3}, {});
  Canvas canvas;
  const Canvas empty;
  const SceneResult result =
      draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory_of_scene);
  CHECK(result.status == Status::kOk);
  CHECK(result.objects == 0);
  CHECK(canvas.pixels == empty.pixels);
}

TEST_CASE("with a background that is refused neither pixels nor depths change") {
  const std::vector<Object> objects(1, Object(kBallView, kRed));
  const Camera camera = looking({0, 0, 3}, {});
  Canvas canvas;
  REQUIRE(ok(draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory_of_scene).status));
  const auto pixels = canvas.pixels;
  const auto depths = canvas.depths;
  const VerticalGradient none{{0, 0, 0}, {255, 255, 255}, 0};
  CHECK(draw_scene({camera, kLights, objects}, canvas.picture, canvas.depth, memory_of_scene, none).status ==
        Status::kInvalidArgument);
  CHECK(canvas.pixels == pixels);
  CHECK(canvas.depths == depths);
}

TEST_CASE("the parts of an object are drawn by their materials") {
  const std::size_t half = kBallView.triangle_count() / 2;
  const Part parts[] = {{&kCopper, 0, half}, {&kRed, half, kBallView.triangle_count() - half}};
  const Object both(kBallView, parts);
  const Part first[] = {{&kCopper, 0, half}};
  const Object one(kBallView, first);
  const Camera camera = looking({1, 3, 3}, {});
  Canvas drawn;
  Canvas expected;
  const SceneResult whole =
      draw_scene({camera, kLights, {&both, 1}}, drawn.picture, drawn.depth, memory_of_scene);
  const SceneResult part =
      draw_scene({camera, kLights, {&one, 1}}, expected.picture, expected.depth, memory_of_scene);
  CHECK(whole.triangles > part.triangles);
  CHECK(whole.objects == 1);
  CHECK(part.triangles > 10);
  int red = 0;
  for (std::int32_t y = 0; y < Canvas::kHeight; ++y) {
    for (std::int32_t x = 0; x < Canvas::kWidth; ++x) {
      if (drawn.picture.pixel(x, y) == Rgb8{200, 30, 20}) {
        ++red;
      } else {
        REQUIRE(drawn.picture.pixel(x, y) == expected.picture.pixel(x, y));
      }
    }
  }
  CHECK(red > 50);
}

TEST_CASE("an object that gets another material is drawn by it alone") {
  const Part parts[] = {{&kRed, 0, 10}};
  Object changed(kBallView, parts);
  changed.set_material(kCopper);
  const Object copper(kBallView, kCopper);
  const Camera camera = looking({1, 3, 3}, {});
  Canvas drawn;
  Canvas expected;
  REQUIRE(
      ok(draw_scene({camera, kLights, {&changed, 1}}, drawn.picture, drawn.depth, memory_of_scene).status));
  REQUIRE(ok(
      draw_scene({camera, kLights, {&copper, 1}}, expected.picture, expected.depth, memory_of_scene).status));
  CHECK(drawn.pixels == expected.pixels);
}

TEST_CASE("parts share vertices where their colours differ") {
  using Smooth = Gouraud<SceneLighting>;
  static constexpr auto kRough = PreparedMaterial<Smooth>::of(matter(Coefficient::of(0.9), {}, {}), kLights);
  static constexpr auto kBlue = PreparedMaterial<Smooth>::of(matter({}, {}, Coefficient::of(0.9)), kLights);
  static SceneMemory<MethodList<Smooth, SceneMethod>, 1, 100> with_vertices;
  static SceneMemory<MethodList<Smooth, SceneMethod>, 1> without_vertices;
  const std::size_t third = kBallView.triangle_count() / 3;
  const Part parts[] = {
      {&kRough, 0, third}, {&kCopper, third, 10}, {&kBlue, third + 10, third}, {&kRough, 2 * third, 20}};
  const Object object(kBallView, parts);
  const Camera camera = looking({1, 3, 3}, {});
  const Scene scene{camera, kLights, {&object, 1}};
  Canvas with;
  Canvas without;
  const SceneResult result = draw_scene(scene, with.picture, with.depth, with_vertices);
  CHECK(result.triangles > 30);
  CHECK(draw_scene(scene, without.picture, without.depth, without_vertices).triangles == result.triangles);
  CHECK(with.pixels == without.pixels);
}
