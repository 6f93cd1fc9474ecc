// SPDX-License-Identifier: MIT
// A copper ring turns on a display of 240x240 pixels, by the library TFT_eSPI. Your own model of one part in
// place of model.h: arcspan mesh MODEL -o model.h --planes
#include <TFT_eSPI.h>
#include <arcspan.h>

#include "model.h"

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;  // light per pixel

constexpr MeshView kMesh = MeshView::of(model::kPositions, model::kNormals, model::kIndices)
                               .with(model::kPlanes, model::kPlaneScale);
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
constexpr auto kCopper = PreparedMaterial<Method>::of(plastic({220, 130, 70}), {kSun});
// The camera stands 3 units before the origin, a little above it. The model has a radius of 1.
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 0.5, 3), {}},
                                      Lens::field_of_view(Turn{8000}, WorldLength::of(1), WorldLength::of(5)), {240, 240});

TFT_eSPI tft;
DisplayBands<240, 16> bands;
SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;
Object ring(kMesh, kCopper);

void setup() {
  Serial.begin(115200);
  tft.init();
  tft.initDMA();
}

void loop() {
  static uint16_t turn = 0;  // 65536 per turn
  ring.rotation = rotation_of(EulerAngles{{turn}, {11000}, {}});
  turn += 400;
  Status status = prepare_scene({kCamera, {kSun}, {&ring, 1}}, scene_memory);
  if (ok(status)) {
    status = bands.show(tft, 240, [](auto& band, auto& depth) {
      return draw_prepared_scene(scene_memory, band, depth, {0, 0, 40}).status;
    });
  }
  if (!ok(status)) Serial.println(to_string(status));
}
