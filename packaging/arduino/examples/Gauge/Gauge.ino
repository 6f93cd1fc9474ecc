// SPDX-License-Identifier: MIT
// A gauge with a caption on a display of 240x240 pixels, by the library Adafruit_ILI9341. The font was made by
//   arcspan font small.bdf -o label.h --range 32,48-57,67,0xB0 --scale 3
#include <Adafruit_ILI9341.h>
#include <arcspan.h>

#include "bezel.h"
#include "label.h"

using namespace arcspan;
using Method = Arc<Illumination<1, Highlight::kPhong>>;

constexpr MeshView kMesh = MeshView::of(bezel::kPositions, bezel::kNormals, bezel::kIndices)
                               .with(bezel::kPlanes, bezel::kPlaneScale);
constexpr SceneLight kSun[] = {SceneLight::directional(normalised(-2, 3, 4))};
constexpr auto kSteel = PreparedMaterial<Method>::of(plastic({150, 160, 175}), {kSun});
constexpr Camera kCamera = Camera::of({WorldPoint::of(0, 0, 4), {}},
                                      Lens::field_of_view(Turn{5600}, WorldLength::of(1), WorldLength::of(6)), {240, 240});

Adafruit_ILI9341 tft(10 /* CS */, 9 /* DC */, 8 /* RST */);
DisplayBands<240, 16> bands;
SceneMemory<MethodList<Method>, 1, kMesh.vertex_count(), kMesh.triangle_count()> scene_memory;
Object ring(kMesh, kSteel);

void setup() {
  tft.begin();
  ring.rotation = Rotation::about_x(Turn{16384});  // it faces the viewer
}

void loop() {
  const int degrees = analogRead(A0) / 8;  // 0...127 of 10 bits: an ESP32 needs analogReadResolution(10) in setup()
  char text[16];
  snprintf(text, sizeof text, "%d \u00B0C", degrees);
  const Turn angle{static_cast<uint16_t>(degrees * 320 - 20480)};
  if (!ok(prepare_scene({kCamera, {kSun}, {&ring, 1}}, scene_memory))) return;
  (void)bands.show(tft, 240, [&](auto& band, auto& depth) {
    Status status = draw_prepared_scene(scene_memory, band, depth, {10, 12, 20}).status;
    if (ok(status)) status = overlay::draw_needle(band, {{120, 120}, angle, 66, 7, 14}, {230, 40, 30});
    if (!ok(status)) return status;
    return overlay::draw_caption(band, label::kFont, {60, 150, 180, 180}, text, Rgb8{255, 255, 255}, overlay::HorizontalAlignment::kCentre);
  });
}
