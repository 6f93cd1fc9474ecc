// SPDX-License-Identifier: MIT
// An attitude indicator of 240x240 pixels, by the library LovyanGFX. It shows the quaternion of a motion sensor.
#define LGFX_AUTODETECT
#include <LovyanGFX.hpp>
#include <LGFX_AUTODETECT.hpp>
#include <arcspan.h>

#include "horizon.h"

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

#define MESH(part) MeshView::of(part::kPositions, part::kNormals, part::kIndices).with(part::kPlanes, part::kPlaneScale)
constexpr MeshView kMeshes[] = {MESH(horizon::sky), MESH(horizon::line), MESH(horizon::ground)};
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
#define MATERIAL(part) PreparedMaterial<Method>::of(part::kMaterial, {kSun})
constexpr auto kSky = MATERIAL(horizon::sky), kLine = MATERIAL(horizon::line), kGround = MATERIAL(horizon::ground);
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 0, 4), {}},
                                      Lens::field_of_view(Turn{5600}, WorldLength::of(1), WorldLength::of(6)), {240, 240});

LGFX tft;
DisplayBands<240, 16> bands;
SceneMemory<MethodList<Method>, 3, 0, 480> scene_memory;  // objects, vertices, triangles
Object ball[] = {{kMeshes[0], kSky}, {kMeshes[1], kLine}, {kMeshes[2], kGround}};

// Put the driver of your sensor here: w, x to the right, y up, z towards the viewer. Here it banks to and fro.
Quaternion read_sensor() {
  const double bank = 0.3 * sin(millis() * 0.001);
  const auto entry = [](double value) { return RotationEntry::from_raw(static_cast<int32_t>(value * 1073741823)); };
  return {entry(cos(bank)), entry(0.1), entry(0), entry(sin(bank))};
}

void setup() { tft.init(); }

void loop() {
  const Quaternion q = read_sensor();
  for (Object& part : ball) part.rotation = rotation_of(q);
  if (!ok(prepare_scene({kCamera, {kSun}, ball}, scene_memory))) return;
  (void)bands.show(tft, 240, [](auto& band, auto& depth) {
    const Status status = draw_prepared_scene(scene_memory, band, depth, {20, 20, 20}).status;
    for (const Rect& wing : {Rect{60, 119, 105, 123}, Rect{135, 119, 180, 123}, Rect{118, 119, 122, 123}})
      if (!ok(overlay::fill_rectangle(band, wing, {255, 210, 0}))) return Status::kUnsupported;
    return status;
  });
}
