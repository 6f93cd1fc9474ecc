// SPDX-License-Identifier: MIT
// A ball in C++11, on a display of 240x240 pixels, by the library TFT_eSPI. Your own model in place of ball.h:
//   arcspan mesh MODEL -o ball.bin && xxd -i ball.bin >ball.h, with alignas(4) const before the array
#include <TFT_eSPI.h>
#include <arcspan_c.h>

#include "ball.h"

enum { kSide = 240, kRows = 16 };
static uint16_t pixels[2][kSide * kRows], depth[kSide * kRows];
static unsigned char scene_memory[4096], view_memory[8192];
TFT_eSPI tft;
arcspan_scene* scene;
arcspan_view* view;
arcspan_object ball;

void setup() {
  tft.init();
  tft.initDMA();
  const arcspan_scene_limits limits = {1, 1};
  arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, &scene);
  arcspan_add_binary(scene, ball_bin, sizeof ball_bin, NULL, &ball);
  const arcspan_view_limits view_limits = arcspan_limits_of(scene, 1);
  arcspan_view_make(view_memory, sizeof view_memory, &view_limits, scene, &view);
  const arcspan_lens lens = {kSide, kSide, ARCSPAN_DEGREES(44), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(5)};
  const arcspan_point eye = {0, 0, ARCSPAN_LENGTH(3)}, origin = {0, 0, 0};
  arcspan_set_camera(view, &lens, eye, origin, origin);
}

void loop() {
  static const arcspan_rgb blue = {0, 0, 40};
  static arcspan_turn yaw = 0;
  arcspan_set_angles(scene, ball, yaw += 300, 0, 0);
  if (arcspan_prepare(view) != ARCSPAN_OK) return;
  for (int top = 0, band = 0; top < kSide; top += kRows, band ^= 1) {  // one is drawn while the other is sent
    const arcspan_target target = {pixels[band], sizeof pixels[band], 2 * kSide, ARCSPAN_RGB565_SWAPPED,
                                   {0, top, kSide, top + kRows}, depth, kSide * kRows, &blue};
    if (arcspan_draw(view, &target) != ARCSPAN_OK) return;
    if (top > 0) tft.dmaWait(); else tft.startWrite();
    tft.pushImageDMA(0, top, kSide, kRows, pixels[band]);
  }
  tft.dmaWait();
  tft.endWrite();
}
