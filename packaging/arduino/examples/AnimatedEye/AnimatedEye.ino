// SPDX-License-Identifier: MIT
// An eye that looks around and blinks, on a round display of 240x240 pixels, by the library Arduino_GFX.
#include <Arduino_GFX_Library.h>
#include <arcspan.h>

#include "eye.h"

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

#define MESH(part) MeshView::of(part::kPositions, part::kNormals, part::kIndices).with(part::kPlanes, part::kPlaneScale)
constexpr MeshView kMeshes[] = {MESH(eye::white), MESH(eye::iris), MESH(eye::pupil), MESH(eye::upper), MESH(eye::lower)};
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
#define MATERIAL(part) PreparedMaterial<Method>::of(part::kMaterial, {kSun})
constexpr auto kBall = MATERIAL(eye::white), kIris = MATERIAL(eye::iris), kPupil = MATERIAL(eye::pupil),
               kSkin = MATERIAL(eye::upper);
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 0, 4), {}},
                                      Lens::field_of_view(Turn{5600}, WorldLength::of(1), WorldLength::of(6)), {240, 240});

Arduino_HWSPI bus(9 /* DC */, 10 /* CS */);
Arduino_GC9A01 tft(&bus, 8 /* RST */, 0, true);
DisplayBands<240, 16> bands;
SceneMemory<MethodList<Method>, 5, 0, 800> scene_memory;  // objects, vertices, triangles
Object parts[] = {{kMeshes[0], kBall}, {kMeshes[1], kIris}, {kMeshes[2], kPupil}, {kMeshes[3], kSkin}, {kMeshes[4], kSkin}};

void setup() { tft.begin(); }

void loop() {
  static Turn yaw, pitch;  // where it looks; every 12 frames somewhere else
  static uint16_t frame = 0;
  if (frame++ % 12 == 0) yaw = Turn{static_cast<uint16_t>(random(-5000, 5000))}, pitch = Turn{static_cast<uint16_t>(random(-3000, 3000))};
  const uint16_t closed = frame % 40 < 4 ? 12000 : 2500;  // of a quarter turn, 16384
  for (int i = 0; i < 3; ++i) parts[i].rotation = rotation_of(EulerAngles{yaw, pitch, {}});
  parts[3].rotation = Rotation::about_x(Turn{static_cast<uint16_t>(closed - 8192)});  // the upper lid
  parts[4].rotation = Rotation::about_x(Turn{static_cast<uint16_t>(8192 - closed)});
  if (!ok(prepare_scene({kCamera, {kSun}, parts}, scene_memory))) return;
  (void)bands.show(tft, 240, [](auto& band, auto& depth) {
    return draw_prepared_scene(scene_memory, band, depth, {0, 0, 0}).status;
  });
}
