// SPDX-License-Identifier: MIT
#include <arcspan/pixel/fog.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
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
constexpr Material kWhitePaint{{kAll, kAll, kAll}, {kAll, kAll, kAll}, {}, 8};
constexpr SceneLight kLamp[] = {SceneLight::point(WorldPoint::of(1, 2, 3), WorldLength::of(3), kAll)};
constexpr LightList kLampLight{kLamp, {Coefficient::of(0.1), Coefficient::of(0.1), Coefficient::of(0.1)}};

constexpr Fog kMist = [] {
  Fog fog;
  const FogRange range{WorldLength::of(0.5).raw(), WorldLength::of(20).raw(), WorldLength::of(2).raw(),
                       WorldLength::of(12).raw()};
  if (!ok(Fog::make(range, {120, 130, 140}, fog))) detail::constant_refused();
  return fog;
}();
constexpr PreparedMaterial<Wall> kPainted = PreparedMaterial<Wall>::of(kWhitePaint, kLampLight)
                                                .with(Texture<DirectTexels<>>::of(kChequers, {3, 3, 1}))
                                                .with(Fogged{&kMist});

SceneMemory<MethodList<Wall>, 2, 8> memory_of_walls;

}  // namespace

TEST_CASE("a textured material in flash is drawn by scenes as by draw_mesh, however its light changes") {
  const Camera camera = [] {
    Camera made;
    REQUIRE(ok(Camera::make({WorldPoint::of(0, 0, 6), {}}, kLens, {Canvas::kWidth, Canvas::kHeight}, made)));
    return made;
  }();
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
    header.lights = kLampLight.lights;
    header.camera = &camera;
    Wall::Method::Lighting lighting;
    REQUIRE(ok(kPainted.light(detail::lights_at(header, wall), lighting)));
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
