/* SPDX-License-Identifier: MIT */
/* A ball in LVGL that turns by itself and by a finger, with a slider for its size and a label over it. Call
 * show_ball() after lv_init() and the creation of a display. */
#include <arcspan.h>
#include <lv_arcspan_view.h>

extern const arcspan_model ball; /* arcspan mesh sphere:16x8 -o ball.cpp --c */

static unsigned char scene_memory[512];

static void on_timer(lv_timer_t* timer) {
  lv_obj_t* const view = lv_timer_get_user_data(timer);
  const arcspan_quaternion step = {1 << 30, 0, 1 << 24, 0}; /* a little, about the upright axis */
  lv_arcspan_view_set_rotation(view, arcspan_multiply(step, lv_arcspan_view_get_rotation(view)));
}

static void on_delete(lv_event_t* e) { lv_timer_delete(lv_event_get_user_data(e)); }

static void on_slider(lv_event_t* e) {
  lv_obj_t* const view = lv_event_get_user_data(e);
  const int32_t percent = lv_slider_get_value(lv_event_get_target_obj(e));
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(1) / 100 * percent);
}

arcspan_status show_ball(void) {
  const arcspan_scene_limits limits = {1, 0};
  arcspan_scene* scene;
  arcspan_object object;
  arcspan_status status = arcspan_scene_make(scene_memory, sizeof scene_memory, &limits, &scene);
  if (status == ARCSPAN_OK) status = arcspan_add_model(scene, &ball, &object);
  if (status != ARCSPAN_OK) return status;

  lv_obj_t* const view = lv_arcspan_view_create(lv_screen_active());
  if (view == NULL) return ARCSPAN_BUFFER_TOO_SMALL;
  lv_obj_set_size(view, LV_PCT(100), LV_PCT(80));
  lv_arcspan_view_set_scene(view, scene);
  lv_arcspan_view_set_turned(view, object);
  lv_obj_add_event_cb(view, on_delete, LV_EVENT_DELETE, lv_timer_create(on_timer, 33, view));

  lv_obj_t* const label = lv_label_create(view);
  lv_label_set_text(label, "arcspan");
  lv_obj_align(label, LV_ALIGN_TOP_MID, 0, 0);

  lv_obj_t* const slider = lv_slider_create(lv_screen_active());
  lv_obj_set_width(slider, LV_PCT(70));
  lv_obj_align(slider, LV_ALIGN_BOTTOM_MID, 0, -8);
  lv_slider_set_range(slider, 20, 120);
  lv_slider_set_value(slider, 100, LV_ANIM_OFF);
  lv_obj_add_event_cb(slider, on_slider, LV_EVENT_VALUE_CHANGED, view);
  return ARCSPAN_OK;
}
