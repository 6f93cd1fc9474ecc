/* SPDX-License-Identifier: MIT */
/* A ball from C, in bands of 16 rows. Where it calls send(), a firmware sends the band to its panel; here
 * send() writes the picture to standard output. The model is made by: arcspan mesh sphere:16x8 -o ball.cpp
 * --c */
#include <arcspan.h>
#include <stdio.h>

extern const arcspan_model ball;

enum { kWidth = 120, kHeight = 120, kRows = 16 };

static uint16_t pixels[kWidth * kRows];
static uint16_t depth[kWidth * kRows];
static unsigned char scene_memory[512];
static unsigned char view_memory[7680];

static void send(const uint16_t* rgb565, int count) {
  for (int i = 0; i < count; ++i) {
    const unsigned p = rgb565[i];
    putchar((int)((p >> 11) * 255 / 31));
    putchar((int)((p >> 5 & 63) * 255 / 63));
    putchar((int)((p & 31) * 255 / 31));
  }
}

static arcspan_status make(arcspan_scene** scene, arcspan_view** view) {
  const arcspan_scene_limits limits = {1, 0};
  arcspan_object object;
  arcspan_status status = arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, scene);
  if (status == ARCSPAN_OK) status = arcspan_add_model(*scene, &ball, &object);
  if (status == ARCSPAN_OK)
    status = arcspan_set_angles(*scene, object, ARCSPAN_DEGREES(20), ARCSPAN_DEGREES(-15), 0);
  if (status != ARCSPAN_OK) return status;

  const arcspan_view_limits view_limits = arcspan_limits_of(*scene, 1);
  status = arcspan_view_make(view_memory, sizeof view_memory, &view_limits, *scene, view);
  if (status != ARCSPAN_OK) return status;
  const arcspan_lens lens = {kWidth, kHeight, ARCSPAN_DEGREES(44), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(5)};
  const arcspan_point eye = {0, ARCSPAN_LENGTH(0.4), ARCSPAN_LENGTH(3)};
  const arcspan_point origin = {0, 0, 0};
  return arcspan_set_camera(*view, &lens, eye, origin, origin);
}

int main(void) {
  const arcspan_rgb blue = {0, 0, 40};
  arcspan_scene* scene;
  arcspan_view* view;
  arcspan_status status = make(&scene, &view);
  if (status == ARCSPAN_OK) status = arcspan_prepare(view);
  printf("P6\n%d %d\n255\n", kWidth, kHeight);
  for (int top = 0; top < kHeight && status == ARCSPAN_OK; top += kRows) {
    const int rows = kHeight - top < kRows ? kHeight - top : kRows;
    const arcspan_target band = {
        pixels, sizeof pixels,  2 * kWidth, ARCSPAN_RGB565, {0, top, kWidth, top + rows},
        depth,  kWidth * kRows, &blue};
    status = arcspan_draw(view, &band);
    if (status == ARCSPAN_OK) send(pixels, kWidth * rows);
  }
  if (status != ARCSPAN_OK) fprintf(stderr, "%s\n", arcspan_status_text(status));
  return status == ARCSPAN_OK ? 0 : 1;
}
