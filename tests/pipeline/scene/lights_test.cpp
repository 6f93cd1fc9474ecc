// SPDX-License-Identifier: MIT
// Lights of the world in the space of an object, and materials under them.
#include <arcspan/shading/flat.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>
#include <tests/support/misuse_recorder.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

using namespace arcspan;
using namespace arcspan::test;

namespace {

/// `v` of the world in the space of an object that is turned by `rotation`.
Vec3 turned_back(const Rotation& rotation, Vec3 v) {
  const auto column = [&](std::size_t j) {
    return std::ldexp(
        rotation.m[0][j].raw() * v.x + rotation.m[1][j].raw() * v.y + rotation.m[2][j].raw() * v.z, -30);
  };
  return {column(0), column(1), column(2)};
}

}  // namespace

TEST_CASE("lights and eye have the directions of double precision in the space of an object") {
  Random random(1841);
  double worst = 0;
  double worst_strength = 0;
  for (int i = 0; i < share_of(20000); ++i) {
    const Rotation rotation = random_rotation(random);
    const Direction towards = to_direction(random_unit(random));
    const DirectionalLight sun = SceneLight::directional(towards).seen_from({}, rotation);
    worst = std::max(worst, angle_between(to_vec3(sun.towards), turned_back(rotation, to_vec3(towards))));

    const double size = random.decades(0.1, 30000);
    const auto point = [&] {
      return to_point({random.real(-size, size), random.real(-size, size), random.real(-size, size)});
    };
    const WorldPoint lamp_at = point();
    const WorldPoint at = point();
    const WorldLength half = to_world(random.decades(0.01, 10000));
    const Vec3 to_lamp = to_vec3(lamp_at) - to_vec3(at);
    const Coefficient strength = Coefficient::from_raw(random.integer(0, 32768));
    const DirectionalLight lamp = SceneLight::point(lamp_at, half, strength).seen_from(at, rotation);
    worst = std::max(worst, angle_between(to_vec3(lamp.towards), turned_back(rotation, to_lamp)));
    const double expected = strength.raw() * to_double(half) / (length(to_lamp) + to_double(half));
    worst_strength = std::max(worst_strength, std::abs(lamp.strength.raw() - expected));
  }
  CHECK(worst < 1.25e-4);  // 0.007 degrees: four times a step of Direction
  CHECK(worst_strength < 1.3);
}

TEST_CASE("a point light in an object's middle shines nowhere, and has half its strength at `half`") {
  const SceneLight lamp = SceneLight::point(WorldPoint::of(1, 2, 3), WorldLength::of(5));
  CHECK(lamp.is_point());
  CHECK(lamp.seen_from(WorldPoint::of(1, 2, 3), Rotation::identity()).towards == Direction{});
  CHECK(lamp.seen_from(WorldPoint::of(1, 2, 3), Rotation::identity()).strength == Coefficient::of(1.0));
  const DirectionalLight seen = lamp.seen_from(WorldPoint::of(1, 7, 3), Rotation::identity());
  CHECK(seen.strength == Coefficient::of(0.5));
  CHECK(seen.towards == arcspan::normalised(0, -1, 0));
}

TEST_CASE("missing lights have no direction and no strength") {
  detail::SceneHeader header;
  const Camera camera;
  header.camera = &camera;
  header.lights = {kLights.lights.first(1)};
  const MeshView mesh;
  const detail::ObjectLights seen = detail::lights_at(header, Object(mesh, kRed));
  for (std::size_t i = 1; i < seen.lights.size(); ++i) {
    CHECK(seen.lights[i].towards == Direction{});
    CHECK(seen.lights[i].strength == Coefficient{});
  }
}

TEST_CASE("the eye's direction turns with camera and object") {
  Camera camera;
  REQUIRE(Camera::make({WorldPoint::of(4, 0, 0), {}}, kLens, kScreen, camera) == Status::kOk);
  detail::SceneHeader header;
  header.camera = &camera;
  const MeshView mesh;
  Object object(mesh, kRed);
  CHECK(detail::lights_at(header, object).to_eye == arcspan::normalised(1, 0, 0));
  object.rotation = Rotation::about_y(Turn{0x4000});  // its z axis points along the world's x
  CHECK(detail::lights_at(header, object).to_eye == arcspan::normalised(0, 0, 1));
  object.position = WorldPoint::of(0, 2, 0);  // it is the camera's axis wherever the object stands
  CHECK(detail::lights_at(header, object).to_eye == arcspan::normalised(0, 0, 1));
}

TEST_CASE("a prepared material is the illumination that make() gives for the object's lights") {
  const Rotation rotation = rotation_of(EulerAngles{{100}, {20000}, {9000}});
  detail::ObjectLights seen;
  for (std::size_t i = 0; i < 2; ++i) seen.lights[i] = kSceneLights[i].seen_from({}, rotation);
  seen.to_eye = rotation.to_object(arcspan::normalised(0, 0, 1));
  seen.ambient = kWhite;
  const Material copper = matter(Coefficient::of(0.8), Coefficient::of(0.4), Coefficient::of(0.2));
  SceneLighting expected;
  REQUIRE(SceneLighting::make(copper, {seen.lights[0], seen.lights[1]}, seen.to_eye, expected) ==
          Status::kOk);
  SceneLighting lighting;
  REQUIRE(kCopper.light(seen, lighting) == Status::kOk);
  Random random(1842);
  for (int i = 0; i < 2000; ++i) {
    const auto scalars = expected.scalars(to_direction(random_unit(random)));
    REQUIRE(lighting.scalars(to_direction(random_unit(random))).size() == scalars.size());
    CHECK(lighting.colour(scalars).lanes == expected.colour(scalars).lanes);
  }
  CHECK(lighting.widest_patch() == expected.widest_patch());
  const Direction up = arcspan::normalised(0, 1, 0);
  CHECK(lighting.scalars(up) == expected.scalars(up));
}

TEST_CASE("a single light is part of the material") {
  using Single = Illumination<1, Highlight::kPhong>;
  using Constant = PreparedMaterial<Flat<Single>>;
  using Changing = PreparedMaterial<Use<Flat<Single>, DrawFeatures{}, true>>;
  static constexpr SceneLight kDay[] = {SceneLight::directional(arcspan::normalised(0, 0, 1))};
  static constexpr LightList kSun{kDay, {Coefficient::of(0.5), Coefficient::of(1.0), Coefficient::of(1.0)}};
  const Material grey = matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5));
  static constexpr auto kConstant =
      Constant::of(matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)), kSun);
  static constexpr auto kChanging =
      Changing::of(matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)), kSun);
  detail::ObjectLights seen;
  seen.lights[0] = kDay[0].seen_from({}, Rotation::identity());
  seen.to_eye = arcspan::normalised(0, 0, 1);
  seen.ambient = kSun.ambient;
  Single lighting;
  REQUIRE(kConstant.light(seen, lighting) == Status::kOk);
  // Red has half of the ambient light.
  const Single dark = lighting;
  CHECK(dark.diffuse_colour({}).rgb8() == Rgb8{13, 26, 26});

  seen.lights[0].strength = Coefficient::of(0.25);
  CHECK(kConstant.light(seen, lighting) == Status::kLightChanged);
  REQUIRE(kChanging.light(seen, lighting) == Status::kOk);
  Material expected = grey;
  expected.ambient.r = Coefficient::from_raw((grey.ambient.r.raw() + 1) / 2);
  Single made;
  REQUIRE(Single::make(expected, {seen.lights[0]}, seen.to_eye, made) == Status::kOk);
  for (int i = 0; i <= 64; ++i) {
    const Cosine c = Cosine::from_raw(i << 24);
    CHECK(lighting.colour({c, c}).lanes == made.colour({c, c}).lanes);
  }
}

TEST_CASE("a point light in an object's middle is no misuse of a material that is made again for it") {
  using Single = Illumination<1, Highlight::kPhong>;
  using Changing = PreparedMaterial<Use<Flat<Single>, DrawFeatures{}, true>>;
  const WorldPoint at = WorldPoint::of(1, 2, 3);
  const Material grey = matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5));
  Changing material;
  REQUIRE(ok(Changing::make(grey, {}, {}, material)));
  detail::ObjectLights seen{};
  seen.lights[0] = SceneLight::point(at, WorldLength::of(5)).seen_from(at, Rotation::identity());
  seen.to_eye = arcspan::normalised(0, 0, 1);
  seen.ambient = kWhite;
  Single lighting;
  MisuseRecorder recorder;
  REQUIRE(ok(material.light(seen, lighting)));
  CHECK(recorder.take().empty());
  const auto scalars = lighting.scalars(arcspan::normalised(0, 0, 1));
  CHECK(lighting.colour(scalars).lanes == lighting.diffuse_colour({}).lanes);
}

TEST_CASE("a point light at the other end of the world is weak, not bright") {
  const SceneLight light = SceneLight::point(WorldPoint::of(32500, 15000, 0), WorldLength::of(1000));
  const DirectionalLight seen = light.seen_from(WorldPoint::of(-32500, -15000, 0), Rotation::identity());
  CHECK(seen.strength.raw() == Approx(32768 * 1000 / (71589.1 + 1000)).margin(1));
}

TEST_CASE("a material from an illumination is for a white light of strength 1") {
  using Single = Illumination<1, Highlight::kPhong>;
  using Constant = PreparedMaterial<Flat<Single>>;
  using Changing = PreparedMaterial<Use<Flat<Single>, DrawFeatures{}, true>>;
  const Material grey = matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5));
  const Direction ahead = arcspan::normalised(0, 0, 1);
  Single made;
  REQUIRE(ok(Single::make(grey, {DirectionalLight{ahead}}, ahead, made)));
  detail::ObjectLights seen{};
  seen.lights[0] = DirectionalLight{ahead};
  seen.to_eye = ahead;
  seen.ambient = kWhite;
  Single lighting;
  REQUIRE(ok(Constant(made).light(seen, lighting)));
  CHECK(lighting.colour(lighting.scalars(ahead)).lanes == made.colour(made.scalars(ahead)).lanes);
  seen.lights[0].strength = Coefficient::of(0.5);
  CHECK(Constant(made).light(seen, lighting) == Status::kLightChanged);
  // It would be made again from a material that it does not have.
  CHECK_FALSE(std::is_constructible_v<Changing, const Single&>);
  CHECK(std::is_default_constructible_v<Changing>);
}

TEST_CASE("ambient light is part of the material") {
  using Single = Illumination<1, Highlight::kPhong>;
  const Material grey = matter(Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5));
  const LightList day{kLights.lights.first(1)};
  PreparedMaterial<Flat<Single>> constant;
  PreparedMaterial<Use<Flat<Single>, DrawFeatures{}, true>> changing;
  PreparedMaterial<Flat<SceneLighting>> of_two;
  REQUIRE(ok(constant.make(grey, day, {}, constant)));
  REQUIRE(ok(changing.make(grey, day, {}, changing)));
  REQUIRE(ok(of_two.make(grey, day, {}, of_two)));
  detail::ObjectLights seen{};
  seen.lights[0] = day.lights[0].seen_from({}, Rotation::identity());
  seen.to_eye = arcspan::normalised(0, 0, 1);
  seen.ambient = kWhite;
  Single lighting;
  SceneLighting lighting_of_two;
  REQUIRE(ok(constant.light(seen, lighting)));
  REQUIRE(ok(of_two.light(seen, lighting_of_two)));
  const Rgb8 by_day = lighting.diffuse_colour({}).rgb8();

  seen.ambient = {};  // at night
  CHECK(constant.light(seen, lighting) == Status::kLightChanged);
  CHECK(of_two.light(seen, lighting_of_two) == Status::kLightChanged);
  REQUIRE(ok(changing.light(seen, lighting)));
  CHECK(by_day.r > 0);
  CHECK(lighting.diffuse_colour({}).rgb8() == Rgb8{});

  REQUIRE(ok(constant.make(grey, {day.lights, {}}, {}, constant)));  // for the night
  CHECK(ok(constant.light(seen, lighting)));
  seen.ambient = kWhite;
  CHECK(constant.light(seen, lighting) == Status::kLightChanged);
}

TEST_CASE("a scene refuses ambient light outside of 0...1") {
  const MeshView mesh;
  const std::vector<Object> objects(1, Object(mesh, kRed));
  Camera camera;
  REQUIRE(ok(Camera::make({WorldPoint::of(4, 0, 0), {}}, kLens, kScreen, camera)));
  SceneMemory<SceneMethods, 1, 0> memory;
  for (const std::int32_t raw : {-1, Coefficient::of(1.0).raw() + 1}) {
    const ChannelCoefficients ambient{Coefficient::from_raw(raw), {}, {}};
    CHECK(prepare_scene({camera, {kLights.lights, ambient}, objects}, memory) == Status::kInvalidArgument);
  }
}

// A scene whose members are constants takes no RAM: this compiles only if all of it is.
namespace {
constexpr ObjectPosition kCorners[] = {{0, 0, 0}, {30000, 0, 0}, {0, 30000, 0}};
constexpr PackedNormal kNormals[3] = {};
constexpr std::uint8_t kIndices[] = {0, 1, 2};
constexpr MeshView kTriangle = MeshView::of(kCorners, kNormals, kIndices);
constexpr Part kParts[] = {{&kCopper, 0, 1}};
constexpr Object kObjects[] = {{kTriangle, kCopper}, {kTriangle, kParts}};
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 0, 3), {}}, kLens, kScreen);
constexpr Scene kScene{kCamera, kLights, kObjects};
}  // namespace

TEST_CASE("a scene can be a constant") {
  STATIC_REQUIRE(kScene.objects[0].sphere() == BoundingSphere{{15000, 15000, 0}, 21214});
  STATIC_REQUIRE(kScene.objects[1].part_count() == 1);
  Canvas canvas;
  static SceneMemory<SceneMethods, 2> memory_of_scene;
  CHECK(draw_scene(kScene, canvas.picture, canvas.depth, memory_of_scene).triangles == 2);
}
