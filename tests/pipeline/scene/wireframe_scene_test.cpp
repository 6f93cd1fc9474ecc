// SPDX-License-Identifier: MIT
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/pixel/pixel_operation.hpp>
#include <arcspan/shading/with_operation.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/scene/scene_support.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using namespace arcspan;
using namespace arcspan::test;

namespace {

constexpr std::size_t kObjects = 100;
constexpr std::array<ObjectPosition, 3> kCorners{{{-20000, -9000, 0}, {25000, 0, 9000}, {0, 22000, -5000}}};
/// Reaches to the top and bottom of its bounding sphere.
constexpr std::array<ObjectPosition, 3> kSlenderCorners{{{0, -32000, 0}, {900, 0, 0}, {0, 32000, 0}}};
constexpr std::array<PackedNormal, 3> kNormals{};
constexpr std::array<std::uint8_t, 3> kTriangle{0, 1, 2};
constexpr MeshView kMesh = MeshView::of(kCorners, kNormals, kTriangle);
constexpr MeshView kSlender = MeshView::of(kSlenderCorners, kNormals, kTriangle);
constexpr PreparedMaterial<Wireframe<>> kWires(Wireframe<>::Lighting(Unlit::lighting({255, 255, 255})),
                                               DrawOptions{.two_sided = true});

SceneMemory<MethodList<Wireframe<>>, kObjects, 3, kObjects> memory_of_wires;

}  // namespace

TEST_CASE("a scene draws wireframes, in bands as at once") {
  const Camera camera = [] {
    Camera made;
    REQUIRE(ok(Camera::make({WorldPoint::of(0, 0, 6), {}}, kLens, {Canvas::kWidth, Canvas::kHeight}, made)));
    return made;
  }();
  Random random(12);
  std::vector<Object> objects;
  for (std::size_t i = 0; i < kObjects; ++i) {
    // Every second one ends near the border of two rows in the middle of the picture, where the bounding
    // sphere is tested most closely, and in columns of its own.
    const bool slender = i % 2 == 1;
    Object object(slender ? kSlender : kMesh, kWires,
                  to_point({random.real(-3, 3), random.real(-3, 3), random.real(-9, 5)}));
    object.scale = to_world(random.real(0.02, 0.2));
    if (slender) {
      const double reach = to_double(object.scale) * 32000 / 32768;
      const double column = 6.0 * static_cast<double>(i) / kObjects - 3;
      object.position = to_point({column, (i % 4 == 1 ? reach : -reach) + random.real(-0.01, 0.01), 0});
    } else {
      object.rotation = random_rotation(random);
    }
    objects.push_back(object);
  }
  const Scene scene{camera, {}, objects};

  // Each object by draw_mesh().
  Canvas single;
  for (const Object& object : objects) {
    ClipTransform transform;
    REQUIRE(camera.place(object.position, object.rotation, object.scale, transform));
    REQUIRE(ok(draw_mesh<Wireframe<>>(object.mesh(), transform, kWires.lighting(), single.picture,
                                      single.depth, {}, kWires.options())
                   .status));
  }
  CHECK(std::count(single.pixels.begin(), single.pixels.end(), Rgb8{255, 255, 255}) > 250);

  for (const std::int32_t rows : {Canvas::kHeight, 1, 4}) {
    INFO(rows << " rows");
    Canvas band(rows);
    std::vector<Rgb8> drawn;
    REQUIRE(ok(prepare_scene(scene, memory_of_wires)));
    for (std::int32_t top = 0; top < Canvas::kHeight; top += rows) {
      band.move_to(top);
      REQUIRE(ok(draw_prepared_scene(memory_of_wires, band.picture, band.depth).status));
      drawn.insert(drawn.end(), band.pixels.begin(), band.pixels.end());
    }
    CHECK(drawn == single.pixels);
  }
}

TEST_CASE("a copy of a wireframe's material has the parameters of its operation") {
  using Faint = Wireframe<WithOperation<Unlit, Opacity<>>>;
  const PreparedMaterial<Faint> wires(
      Faint::Lighting(WithOperation<Unlit, Opacity<>>::Lighting(Unlit::lighting({}))));
  CHECK(wires.with(Opacity<>{5}).lighting().operation.opacity == 5);
  CHECK(wires.with(DepthBias{3}).lighting().bias.units == 3);
}
