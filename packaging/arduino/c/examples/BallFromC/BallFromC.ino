// SPDX-License-Identifier: MIT
// A ball in C++11, on a display of 240x240 pixels, by the library TFT_eSPI. Your own model in place of ball.h:
//   arcspan mesh MODEL -o ball.h --c
#include <TFT_eSPI.h>
#include <arcspan_c.h>
#include "ball.h"

enum { kSide = 240, kRows = 16 };
static uint16_t pixels[2][kSide * kRows], depth[kSide * kRows];
static unsigned char scene_memory[4096], view_memory[8192];  // a larger model needs more: "buffer too small"
static arcspan_scene* scene;
static arcspan_view* view;
static arcspan_object object;
static arcspan_status status;
TFT_eSPI tft;

void setup() {
  Serial.begin(115200);
  tft.init(), tft.initDMA();
  const arcspan_scene_limits limits = {1, 1};  // parts, materials
  status = arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, &scene);
  if (status == ARCSPAN_OK) status = arcspan_add_binary(scene, ball, sizeof ball, NULL, &object);
  if (status != ARCSPAN_OK) return;
  const arcspan_view_limits view_limits = arcspan_limits_of(scene, 1);
  status = arcspan_view_make(view_memory, sizeof view_memory, &view_limits, scene, &view);
  const arcspan_lens lens = {kSide, kSide, ARCSPAN_DEGREES(44), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(5)};
  const arcspan_point eye = {0, 0, ARCSPAN_LENGTH(3)}, origin = {0, 0, 0};
  if (status == ARCSPAN_OK) status = arcspan_set_camera(view, &lens, eye, origin, origin);
}

void loop() {
  static arcspan_turn yaw = 0;
  if (status == ARCSPAN_OK) arcspan_set_angles(scene, object, yaw += 300, 0, 0), status = arcspan_prepare(view);
  tft.startWrite();
  for (int top = 0, band = 0; top < kSide && status == ARCSPAN_OK; top += kRows, band ^= 1) {
    static const arcspan_rgb blue = {0, 0, 40};
    const arcspan_target target = {pixels[band], sizeof pixels[band], 2 * kSide, ARCSPAN_RGB565_SWAPPED,
                                   {0, top, kSide, top + kRows}, depth, kSide * kRows, &blue};
    status = arcspan_draw(view, &target);
    tft.dmaWait();  // one band is drawn while the other is sent
    tft.pushImageDMA(0, top, kSide, kRows, pixels[band]);
  }
  tft.dmaWait(), tft.endWrite();
  if (status != ARCSPAN_OK) Serial.println(arcspan_status_text(status));
}
