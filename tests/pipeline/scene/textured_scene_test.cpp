// SPDX-License-Identifier: MIT
#include <arcspan/pixel/fog.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/with_operation.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <catch2/catch.hpp>
#include <tests/frames/integer_shapes.hpp>
#include <tests/pipeline/scene/scene_support.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

using namespace arcspan;
using namespace arcspan::test;

namespace {

using OneLight = Illumination<1, Highlight::kBlinn>;
using Wall =
    Use<WithOperation<Textured<GreyGouraud<OneLight>, DirectTexels<>>, Fogged>, DrawFeatures{}, true>;

constexpr std::array<std::uint16_t, 64> kChequers = [] {
  std::array<std::uint16_t, 64> words{};
  for (std::size_t i = 0; i < 64; ++i) words[i] = ((i ^ (i >> 3)) & 1) != 0 ? 0xFFFF : 0x8000;
  return words;
}();
constexpr std::array<ObjectPosition, 4> kCorners{
    {{-30000, -20000, 9000}, {30000, -20000, -9000}, {30000, 20000, -9000}, {-30000, 20000, 9000}}};
constexpr std::array<PackedNormal, 4> kNormals{};
constexpr std::array<std::uint8_t, 6> kTriangles{0, 1, 2, 0, 2, 3};
constexpr std::array<TexturePoint, 4> kPoints{{{0, 8192}, {8192, 8192}, {8192, 0}, {0, 0}}};
constexpr MeshView kWall = MeshView::of(kCorners, kNormals, kTriangles).with(kPoints, TextureScale{12});

constexpr Coefficient kAll = Coefficient::of(1.0);
constexpr Coefficient kHalf = Coefficient::of(0.5);
constexpr Material kWhitePaint{{kAll, kAll, kAll}, {kAll, kAll, kAll}, {}, 8};
constexpr SceneLight kLamp[] = {SceneLight::point(WorldPoint::of(1, 2, 3), WorldLength::of(3), kAll)};
constexpr LightList kLampLight{kLamp, {Coefficient::of(0.1), Coefficient::of(0.1), Coefficient::of(0.1)}};

constexpr Fog kMist = [] {
  Fog fog;
  const FogRange range{WorldLength::of(0.5).raw(), WorldLength::of(20).raw(), WorldLength::of(2).raw(),
                       WorldLength::of(12).raw()};
  if (!ok(Fog::make(range, {120, 130, 140}, fog))) detail::refused::constant_refused();
  return fog;
}();
constexpr PreparedMaterial<Wall> kPainted = PreparedMaterial<Wall>::of(kWhitePaint, kLampLight)
                                                .with(Texture<DirectTexels<>>::of(kChequers, {3, 3, 1}))
                                                .with(Fogged{&kMist});

/// The same paint without texture and fog.
using BareWall = Use<GreyGouraud<OneLight>, DrawFeatures{}, true>;
constexpr auto kBare = PreparedMaterial<BareWall>::of(kWhitePaint, kLampLight);

SceneMemory<MethodList<Wall>, 2, 8> memory_of_walls;

using Pane = WithOperation<Unlit, Opacity<>>;
SceneMemory<MethodList<Pane>, 2, 8> memory_of_panes;

using Chrome = Arc<EnvironmentMap<DirectTexels<>>>;
SceneMemory<MethodList<Chrome>, 2, 200> memory_of_chrome;

Camera camera_at(const WorldPoint& eye) {
  Camera camera;
  REQUIRE(ok(Camera::make({eye, {}}, kLens, kScreen, camera)));
  return camera;
}

}  // namespace

TEST_CASE("a textured material in flash is drawn by scenes as by draw_mesh, however its light changes") {
  const Camera camera = camera_at(WorldPoint::of(0, 0, 6));
  std::array<Object, 2> walls{Object(kWall, kPainted, WorldPoint::of(-1, 0, 0)),
                              Object(kWall, kPainted, WorldPoint::of(2, 1, -4))};
  for (Object& wall : walls) wall.scale = WorldLength::of(2);
  Canvas scene_canvas;
  const Scene scene{camera, kLampLight, walls};
  const SceneResult drawn = draw_scene(scene, scene_canvas.picture, scene_canvas.depth, memory_of_walls);
  REQUIRE(drawn.status == Status::kOk);
  REQUIRE(drawn.triangles == 4);

  Canvas mesh_canvas;
  for (const Object& wall : walls) {
    ClipTransform transform;
    REQUIRE(camera.place(wall.position, wall.rotation, wall.scale, transform));
    detail::SceneHeader header;
    header.lights = kLampLight;
    header.camera = &camera;
    Wall::Method::Lighting lighting;
    REQUIRE(ok(kPainted.light(detail::lights_at(header, wall), lighting)));
    OneLight bare;
    REQUIRE(ok(kBare.light(detail::lights_at(header, wall), bare)));
    CHECK(lighting.ramp().back().lanes == bare.ramp().back().lanes);
    REQUIRE(ok(
        draw_mesh<Wall::Method>(kWall, transform, lighting, mesh_canvas.picture, mesh_canvas.depth).status));
  }
  CHECK(scene_canvas.pixels == mesh_canvas.pixels);

  // The wall that is farther from the lamp and in thicker fog shows less contrast.
  const auto contrast = [&](std::int32_t left, std::int32_t right) {
    int least = 255;
    int most = 0;
    for (std::int32_t x = left; x < right; ++x) {
      const int red = scene_canvas.picture.pixel(x, Canvas::kHeight / 2).r;
      least = red < least ? red : least;
      most = red > most ? red : most;
    }
    return most - least;
  };
  CHECK(contrast(14, 45) > 30);
  CHECK(contrast(60, 70) > 10);
  CHECK(2 * contrast(14, 45) > 3 * contrast(60, 70));
}

TEST_CASE("transparent objects are drawn from far to near where depth is only read") {
  const Camera camera = camera_at(WorldPoint::of(0, 0, 6));
  const PreparedMaterial<Pane> red(Pane::Lighting(Unlit::lighting({240, 0, 0}), Opacity<>{16}));
  const PreparedMaterial<Pane> blue(Pane::Lighting(Unlit::lighting({0, 0, 240}), Opacity<>{16}));
  const std::array<Object, 2> near_first{Object(kWall, red, WorldPoint::of(0, 0, 1)),
                                         Object(kWall, blue, WorldPoint::of(0, 0, -1))};
  const std::array<Object, 2> far_first{near_first[1], near_first[0]};
  for (const auto* panes : {&near_first, &far_first}) {
    Canvas canvas;
    canvas.picture.clear({});
    const Scene scene{camera, kLampLight, *panes};
    const SceneResult drawn = draw_scene(scene, canvas.picture, ReadOnlyDepth(canvas.depth), memory_of_panes);
    REQUIRE(drawn.status == Status::kOk);
    REQUIRE(drawn.triangles == 4);
    const Rgb8 middle = canvas.picture.pixel(Canvas::kWidth / 2, Canvas::kHeight / 2);
    CHECK(middle.r > 110);
    CHECK(middle.b > 50);
    CHECK(middle.b < 70);
  }
}

TEST_CASE("an environment map follows the camera and the rotation of each object") {
  static const auto kBall = scenes::make_sphere<8, 4>();
  MeshView ball;
  REQUIRE(ok(kBall.view(ball)));
  const PreparedMaterial<Chrome> chrome(
      EnvironmentMap<DirectTexels<>>(Texture<DirectTexels<>>::of(kChequers, {3, 3, 1})));
  std::array<Object, 2> balls{Object(ball, chrome, WorldPoint::of(-1, 0, 0)),
                              Object(ball, chrome, WorldPoint::of(1.2, 0.5, -2))};
  balls[0].rotation = Rotation::about_x({9000}) * Rotation::about_y({20000});
  balls[1].rotation = Rotation::about_z({30000});
  for (Object& one : balls) one.scale = WorldLength::of(2);
  const Camera camera = camera_at(WorldPoint::of(3, 2, 5));
  Canvas of_scene;
  const Scene scene{camera, kLampLight, balls};
  REQUIRE(draw_scene(scene, of_scene.picture, of_scene.depth, memory_of_chrome).status == Status::kOk);

  Canvas of_meshes;
  for (const Object& one : balls) {
    ClipTransform transform;
    REQUIRE(camera.place(one.position, one.rotation, one.scale, transform));
    const EnvironmentMap<DirectTexels<>> seen(Texture<DirectTexels<>>::of(kChequers, {3, 3, 1}),
                                              camera.rotation() * one.rotation);
    REQUIRE(draw_mesh<Chrome>(ball, transform, seen, of_meshes.picture, of_meshes.depth).status ==
            Status::kOk);
  }
  CHECK(of_scene.pixels == of_meshes.pixels);
}

TEST_CASE("a material that is made again keeps its texture and its fog, and one that is refused stays") {
  PreparedMaterial<Wall> made = kPainted;
  constexpr Material kGreyPaint{{kHalf, kHalf, kHalf}, {kHalf, kHalf, kHalf}, {}, 8};
  REQUIRE(ok(PreparedMaterial<Wall>::make(kGreyPaint, kLampLight, {.two_sided = true}, made)));
  CHECK(made.lighting().ramp().back().lanes < kPainted.lighting().ramp().back().lanes);
  CHECK(made.lighting().texture.at(0) == kChequers.data());
  CHECK(made.lighting().operation.fog == &kMist);
  CHECK(made.options().two_sided);
  const SceneLight two[] = {kLamp[0], kLamp[0]};
  CHECK(PreparedMaterial<Wall>::make(kWhitePaint, {two}, {}, made) == Status::kTooManyLights);
  Material dazzling = kWhitePaint;
  dazzling.diffuse.r = Coefficient::from_raw(-1);
  CHECK(PreparedMaterial<Wall>::make(dazzling, kLampLight, {}, made) == Status::kInvalidArgument);
  CHECK(made.options().two_sided);
  REQUIRE(ok(PreparedMaterial<Wall>::make(kWhitePaint, kLampLight, {}, made)));
  for (std::size_t i = 0; i < made.lighting().ramp().size(); ++i)
    REQUIRE(made.lighting().ramp()[i].lanes == kPainted.lighting().ramp()[i].lanes);
  CHECK_FALSE(made.options().two_sided);
}
