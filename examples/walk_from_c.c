/* SPDX-License-Identifier: MIT */
/* A character from C, with ARCSPAN_C_CHARACTERS=1: it stands, begins to walk and turns, in bands of 16 rows.
 * Where it calls send(), a firmware sends the band to its panel; here send() writes the last picture to
 * standard output. The model is made by: arcspan mesh examples/walker/walker.glb -o walker.h --c */
#include "walker.h"

#include <arcspan.h>
#include <stdio.h>

enum { kWidth = 120, kHeight = 160, kRows = 16, kFrames = 20, kFrameTime = 50000 /* microseconds */ };

static uint16_t pixels[kWidth * kRows], depth[kWidth * kRows];
static unsigned char scene_memory[9472], character_memory[3072], view_memory[24064];

static void send(const uint16_t* rgb565, int count) {
  for (int i = 0; i < count; ++i) {
    const unsigned p = rgb565[i];
    putchar((int)((p >> 11) * 255 / 31));
    putchar((int)((p >> 5 & 63) * 255 / 63));
    putchar((int)((p & 31) * 255 / 31));
  }
}

static arcspan_status make(arcspan_scene** scene, arcspan_character** man, arcspan_view** view) {
  const arcspan_scene_limits limits = {4, 4}; /* the parts of the model and their materials */
  arcspan_status status = arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, scene);
  if (status == ARCSPAN_OK)
    status = arcspan_add_character(*scene, walker, sizeof walker, NULL, character_memory,
                                   sizeof character_memory, man);
  if (status != ARCSPAN_OK) return status;
  const arcspan_view_limits view_limits = arcspan_limits_of(*scene, 1);
  status = arcspan_view_make(view_memory, sizeof view_memory, &view_limits, *scene, view);
  if (status != ARCSPAN_OK) return status;
  const arcspan_lens lens = {kWidth, kHeight, ARCSPAN_DEGREES(38), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(9)};
  const arcspan_point eye = {0, 0, ARCSPAN_LENGTH(3.2)}, origin = {0, 0, 0};
  return arcspan_set_camera(*view, &lens, eye, origin, origin);
}

static arcspan_status draw(arcspan_view* view, int sends) {
  const arcspan_rgb blue = {20, 30, 60};
  arcspan_status status = arcspan_prepare(view);
  for (int top = 0; top < kHeight && status == ARCSPAN_OK; top += kRows) {
    const arcspan_target band = {
        pixels, sizeof pixels,  2 * kWidth, ARCSPAN_RGB565, {0, top, kWidth, top + kRows},
        depth,  kWidth * kRows, &blue};
    status = arcspan_draw(view, &band);
    if (status == ARCSPAN_OK && sends) send(pixels, kWidth * kRows);
  }
  return status;
}

int main(void) {
  arcspan_scene* scene;
  arcspan_character* man;
  arcspan_view* view;
  arcspan_status status = make(&scene, &man, &view);
  if (status == ARCSPAN_OK) status = arcspan_play(man, arcspan_find_clip(man, "stand"), 0, ARCSPAN_REPEAT);
  printf("P6\n%d %d\n255\n", kWidth, kHeight);
  for (int frame = 0; frame < kFrames && status == ARCSPAN_OK; ++frame) {
    if (frame == 5) status = arcspan_play(man, arcspan_find_clip(man, "walk"), 200000, ARCSPAN_REPEAT);
    arcspan_advance(man, kFrameTime);
    arcspan_set_angles(scene, arcspan_object_of(man), (arcspan_turn)(400 * frame), 0, 0);
    if (status == ARCSPAN_OK) status = draw(view, frame + 1 == kFrames);
  }
  if (status != ARCSPAN_OK) fprintf(stderr, "%s\n", arcspan_status_text(status));
  return status == ARCSPAN_OK ? 0 : 1;
}
