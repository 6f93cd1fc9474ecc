// SPDX-License-Identifier: MIT
// A scene on a display: a torus and a cube turn under two lights, drawn in bands on an ILI9341 of 240x320
// pixels. Meshes, materials, lights and camera are constants in flash. For a board of your own, write an
// Ili9341Board with its SPI bus and pins (docs/hal.md).
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/scene.hpp>
#include <arcspan/shading/surface/arc.hpp>

#include <ili9341_board.hpp>
#include <tests/frames/shape_views.hpp>

using namespace arcspan;
using Light = Illumination<2, Highlight::kBlinn>;
// The meshes have no planes, and their triangles are large.
using Method = Use<Arc<Light>, DrawFeatures{.planes = false, .small_triangles = false}>;
using Pages = hal::PageMode<hal::Ili9341>;

constexpr SceneLight kLamps[] = {SceneLight::directional(normalised(3, 4, 5), Coefficient::of(0.7)),
                                 SceneLight::point(WorldPoint::of(-2, 1, 2), WorldLength::of(2))};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 140, 70}), {kLamps});
constexpr auto kJade = PreparedMaterial<Method>::of(plastic({80, 200, 140}), {kLamps});
constexpr Camera kCamera =
    Camera::of({WorldPoint::of(0, 0.4, 2.4), {}},
               Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(8)), {240, 320});

constexpr std::int32_t kRows = 16;
Pages::Frame::Word band_memory[Pages::Frame::words(240, kRows)];
std::uint8_t wire_memory[hal::wire_bytes<hal::Ili9341>(240, kRows)];
std::uint16_t depth_memory[DepthBuffer::words(240, kRows)];
SceneMemory<MethodList<Method>, 2, 312, 588> scene_memory;  // objects, vertices, triangles

int main() {
  Ili9341Board board;
  Pages pages(board.panel(), band_memory, wire_memory, kRows);
  Object objects[] = {{scenes::kTorus, kCopper}, {scenes::kCube, kJade, WorldPoint::of(0.3, -0.5, 0)}};
  Status status = board.start();
  for (std::uint16_t turn = 0; ok(status) && turn < 2000; turn += 1000) {
    for (Object& object : objects) object.rotation = rotation_of(EulerAngles{{turn}, {5000}, {}});
    status = prepare_scene({kCamera, {kLamps}, objects}, scene_memory);
    if (!ok(status)) break;
    status = pages.show([](Pages::Frame& band) {
      DepthBuffer depth(depth_memory, 240, kRows, band.bounds().top);
      return draw_prepared_scene(scene_memory, band, depth, {0, 0, 40}).status;
    });
  }
  return ok(status) ? 0 : 1;
}
