/* SPDX-License-Identifier: MIT */
#include "frames.h"

#include <lv_arcspan_view.h>

extern const arcspan_model ball;

const uint32_t lvgl_frame_hashes[LVGL_FRAMES] = {454672327u, 795726194u, 2303394093u, 2774681068u,
                                                 2957791483u};

enum { kWidth = 320, kHeight = 240, kRows = 40, kMost = 32 };

static const arcspan_quaternion kStep = {1 << 30, 1 << 26, 1 << 28, 0};

static uint16_t buffer[kWidth * kRows];
static uint16_t depth[kWidth * kHeight];
static unsigned char scene_memory[512];
static unsigned char bare_memory[9600];
static arcspan_scene* scene;
static arcspan_object object;
static lv_obj_t* view;
static uint32_t hash;

/* Rectangles that the widget has drawn in the last frame, and areas that it has invalidated. */
static arcspan_target drawn[kMost];
static uint32_t drawn_count;
static lv_area_t invalidated[kMost];
static uint32_t invalidated_count;
static bool is_bare;

static void flush(lv_display_t* display, const lv_area_t* area, uint8_t* bytes) {
  const uint32_t count = 2 * lv_area_get_size(area);
  for (uint32_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 16777619u;
  lv_display_flush_ready(display);
}

static void on_invalidate(lv_event_t* e) {
  const lv_area_t* const area = lv_event_get_invalidated_area(e);
  const bool is_question = area->x1 == 0 && area->y1 == 0 && area->x2 == 0; /* of LVGL, about rows */
  if (!is_question && invalidated_count < kMost) invalidated[invalidated_count++] = *area;
}

/* The linker calls this for arcspan_draw() (--wrap). */
arcspan_status __real_arcspan_draw(arcspan_view* seen, const arcspan_target* target);
arcspan_status __wrap_arcspan_draw(arcspan_view* seen, const arcspan_target* target);
arcspan_status __wrap_arcspan_draw(arcspan_view* seen, const arcspan_target* target) {
  if (!is_bare && drawn_count < kMost) drawn[drawn_count++] = *target;
  return __real_arcspan_draw(seen, target);
}

static void make_widgets(void) {
  view = lv_arcspan_view_create(lv_screen_active());
  lv_obj_set_size(view, 216, 156);
  lv_obj_align(view, LV_ALIGN_TOP_MID, 0, 4);
  lv_arcspan_view_set_scene(view, scene);
  lv_arcspan_view_set_turned(view, object);
  lv_obj_t* const label = lv_label_create(view);
  lv_label_set_text(label, "arcspan");
  lv_obj_t* const slider = lv_slider_create(lv_screen_active());
  lv_obj_set_width(slider, 100);
  lv_obj_align(slider, LV_ALIGN_BOTTOM_MID, 0, -8);
  lv_slider_set_value(slider, 40, LV_ANIM_OFF);
}

arcspan_status lvgl_frames_start(void) {
  const arcspan_scene_limits limits = {1, 0};
  arcspan_status status = arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, &scene);
  if (status == ARCSPAN_OK) status = arcspan_add_model(scene, &ball, &object);
  if (status != ARCSPAN_OK) return status;
  lv_init();
  lv_display_t* const display = lv_display_create(kWidth, kHeight);
  lv_display_set_buffers(display, buffer, NULL, sizeof buffer, LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_display_set_flush_cb(display, flush);
  lv_display_add_event_cb(display, on_invalidate, LV_EVENT_INVALIDATE_AREA, NULL);
  make_widgets();
  return ARCSPAN_OK;
}

uint32_t lvgl_frames_next(void) {
  lv_arcspan_view_set_rotation(view, arcspan_multiply(kStep, lv_arcspan_view_get_rotation(view)));
  hash = 2166136261u;
  drawn_count = 0;
  invalidated_count = 0;
  lv_refr_now(NULL);
  return hash;
}

void lvgl_frames_show_scene(bool shown) {
  const uint32_t count = invalidated_count;
  lv_arcspan_view_set_scene(view, shown ? scene : NULL);
  lv_refr_now(NULL);
  invalidated_count = count;
}

void lvgl_frames_again(void) {
  const uint32_t count = invalidated_count;
  for (uint32_t i = 0; i < count; ++i) lv_obj_invalidate_area(lv_screen_active(), &invalidated[i]);
  lv_refr_now(NULL);
}

uint32_t lvgl_frames_bare(void) {
  static arcspan_view* bare;
  static arcspan_quaternion rotation = {1 << 30, 0, 0, 0};
  if (bare == NULL) {
    const arcspan_view_limits limits = arcspan_limits_of(scene, 1); /* as the widget takes */
    if (arcspan_view_make(bare_memory, sizeof bare_memory, &limits, scene, &bare) != ARCSPAN_OK) return 0;
  }
  lv_area_t picture;
  lv_obj_get_content_coords(view, &picture);
  const arcspan_lens lens = {(uint16_t)lv_area_get_width(&picture),
                             (uint16_t)lv_area_get_height(&picture),
                             ARCSPAN_DEGREES(45),
                             0,
                             ARCSPAN_LENGTH(1),
                             ARCSPAN_LENGTH(16)};
  const arcspan_point eye = {0, 0, ARCSPAN_LENGTH(3)};
  const arcspan_point origin = {0, 0, 0};
  is_bare = true;
  (void)arcspan_set_camera(bare, &lens, eye, origin, origin);
  rotation = arcspan_multiply(kStep, rotation);
  (void)arcspan_set_quaternion(scene, object, rotation);
  (void)arcspan_prepare(bare);
  (void)arcspan_drawn_rect(bare);
  for (uint32_t i = 0; i < drawn_count; ++i) {
    arcspan_target target = drawn[i];
    target.pixels = buffer;
    target.bytes = sizeof buffer;
    target.depth = depth;
    (void)arcspan_draw(bare, &target);
  }
  is_bare = false;
  return drawn_count;
}
