/* SPDX-License-Identifier: MIT */
/* The draw unit behind lv_arcspan_view. Its tasks are image tasks of a colour format that other units that
 * draw into memory do not take, so that LVGL orders, clips and layers them as all others. LVGL 9.6 does not
 * check whether there is memory for a unit or a task, so neither does this file. */
#include "lv_arcspan_view_private.h"

/* Of the formats from LV_COLOR_FORMAT_PROPRIETARY_START on, those that LVGL does not use. */
#define SCENE_FORMAT 0x3F
#define UNIT_ID 63
#define UNIT_NAME "arcspan"

typedef struct {
  lv_draw_unit_t base;
  uint16_t* depth; /* grows to the largest rectangle that was drawn */
  size_t depth_words;
} scene_unit_t;

/* The arcspan_format of a colour format, or 255. */
static arcspan_format format_of(lv_color_format_t format) {
  switch (format) {
    case LV_COLOR_FORMAT_RGB565:
      return ARCSPAN_RGB565;
    case LV_COLOR_FORMAT_RGB565_SWAPPED:
      return ARCSPAN_RGB565_SWAPPED;
    case LV_COLOR_FORMAT_RGB888:
      return ARCSPAN_BGR888;
    case LV_COLOR_FORMAT_XRGB8888:
      return ARCSPAN_XRGB8888;
    case LV_COLOR_FORMAT_ARGB8888:
      return ARCSPAN_ARGB8888;
    case LV_COLOR_FORMAT_L8:
      return ARCSPAN_GRAY8;
    default:
      return 255;
  }
}

/* Makes room for the depths of some rows, all if there is memory. Returns how many. */
static int32_t rows_with_depth(scene_unit_t* unit, int32_t width, int32_t rows) {
  const size_t row = (size_t)width;
  if (unit->depth_words >= row * (size_t)rows) return rows;
  lv_free(unit->depth); /* first, because its contents are of no use */
  unit->depth = NULL;
  unit->depth_words = 0;
  for (int32_t wanted = rows; wanted > 0; wanted /= 2) {
    unit->depth = lv_malloc(sizeof(uint16_t) * row * (size_t)wanted);
    if (unit->depth == NULL) continue;
    unit->depth_words = row * (size_t)wanted;
    return wanted;
  }
  return 0;
}

/* Of drawing a rectangle. Where outlines are not smooth, the view gets the status, but nothing is missing. */
static arcspan_status status_of(lv_arcspan_view_t* view, arcspan_status status) {
#if LV_ARCSPAN_OUTLINES
  if (view->more != 0 && (status == ARCSPAN_BUFFER_TOO_SMALL || status == ARCSPAN_UNSUPPORTED ||
                          status == ARCSPAN_SCALE_OUT_OF_RANGE)) {
    view->status = status;
    return ARCSPAN_OK;
  }
#else
  LV_UNUSED(view);
#endif
  return status;
}

static arcspan_status draw_rows(scene_unit_t* unit, lv_arcspan_view_t* view, lv_layer_t* layer,
                                const lv_area_t* area, lv_point_t origin) {
  lv_draw_buf_t* const buffer = layer->draw_buf;
  const int32_t x = area->x1 - layer->buf_area.x1;
  const int32_t y = area->y1 - layer->buf_area.y1;
  uint8_t* const pixels = lv_draw_buf_goto_xy(buffer, (uint32_t)x, (uint32_t)y);
  const arcspan_target target = {
      .pixels = pixels,
      .bytes = buffer->data_size - (size_t)(pixels - buffer->data),
      .stride = (int32_t)buffer->header.stride,
      .format = format_of((lv_color_format_t)buffer->header.cf),
      .held = {area->x1 - origin.x, area->y1 - origin.y, area->x2 + 1 - origin.x, area->y2 + 1 - origin.y},
      .depth = unit->depth,
      .depth_words = unit->depth_words,
      .background = NULL,
  };
  return status_of(view, arcspan_draw(view->view, &target));
}

static arcspan_status draw(scene_unit_t* unit, lv_arcspan_view_t* view, lv_draw_task_t* task) {
  lv_layer_t* const layer = task->target_layer;
  const lv_draw_image_dsc_t* const descriptor = task->draw_dsc;
  const lv_point_t origin = {descriptor->image_area.x1, descriptor->image_area.y1};
  lv_area_t rest;
  if (!lv_area_intersect(&rest, &task->area, &task->clip_area)) return ARCSPAN_OK;
  if (!lv_area_intersect(&rest, &rest, &layer->buf_area)) return ARCSPAN_OK;
#if LV_DRAW_TRANSFORM_USE_MATRIX
  if (!lv_matrix_is_identity(&task->matrix)) return ARCSPAN_UNSUPPORTED;
#endif
  if (view->view == NULL) return ARCSPAN_NOT_READY;
  const int32_t rows = rows_with_depth(unit, lv_area_get_width(&rest), lv_area_get_height(&rest));
  if (rows == 0) return ARCSPAN_BUFFER_TOO_SMALL;
#if LV_ARCSPAN_OUTLINES
  /* Strips would lack the pixels on the other side. */
  if (view->more != 0 && rows < lv_area_get_height(&rest)) return ARCSPAN_BUFFER_TOO_SMALL;
#endif
  arcspan_status status = ARCSPAN_OK;
  for (lv_area_t strip = rest; strip.y1 <= rest.y2 && status == ARCSPAN_OK; strip.y1 += rows) {
    strip.y2 = LV_MIN(strip.y1 + rows - 1, rest.y2);
    status = draw_rows(unit, view, layer, &strip, origin);
  }
  return status;
}

static int32_t evaluate(lv_draw_unit_t* unit, lv_draw_task_t* task) {
  LV_UNUSED(unit);
  if (task->type != LV_DRAW_TASK_TYPE_IMAGE) return 0;
  if (((const lv_draw_image_dsc_t*)task->draw_dsc)->header.cf != SCENE_FORMAT) return 0;
  task->preferred_draw_unit_id = UNIT_ID;
  task->preference_score = 0;
  return 1;
}

/* Draws at once, in LVGL's thread; threads of other units go on meanwhile. */
static int32_t dispatch(lv_draw_unit_t* base, lv_layer_t* layer) {
  lv_draw_task_t* const task = lv_draw_get_next_available_task(layer, NULL, UNIT_ID);
  if (task == NULL || task->preferred_draw_unit_id != UNIT_ID) return LV_DRAW_UNIT_IDLE;
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)((lv_draw_image_dsc_t*)task->draw_dsc)->src;
  arcspan_status status = ARCSPAN_BUFFER_TOO_SMALL;
  if (lv_draw_layer_alloc_buf(layer) != NULL) {
    task->state = LV_DRAW_TASK_STATE_IN_PROGRESS;
    status = draw((scene_unit_t*)base, view, task);
  }
  if (status != ARCSPAN_OK) lv_arcspan_view_drop(view, status);
  task->state = LV_DRAW_TASK_STATE_FINISHED;
  lv_draw_dispatch_request();
  return 1;
}

static int32_t delete_unit(lv_draw_unit_t* base) {
  lv_free(((scene_unit_t*)base)->depth);
  return 0;
}

/* LVGL frees its units in lv_deinit(), so that a pointer to ours would not last. */
static bool is_registered(void) {
  for (const lv_draw_unit_t* unit = LV_GLOBAL_DEFAULT()->draw_info.unit_head; unit != NULL;
       unit = unit->next) {
    if (unit->dispatch_cb == dispatch) return true;
  }
  return false;
}

void lv_arcspan_unit_init(void) {
  if (is_registered()) return;
  scene_unit_t* const unit = lv_draw_create_unit(sizeof(scene_unit_t));
  unit->base.name = UNIT_NAME;
  unit->base.evaluate_cb = evaluate;
  unit->base.dispatch_cb = dispatch;
  unit->base.delete_cb = delete_unit;
}

void lv_arcspan_unit_add_task(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* area,
                              lv_point_t origin) {
  lv_draw_task_t* const task = lv_draw_add_task(layer, area, LV_DRAW_TASK_TYPE_IMAGE);
  lv_draw_image_dsc_t* const descriptor = task->draw_dsc;
  lv_draw_image_dsc_init(descriptor);
  descriptor->base.obj = &view->obj;
  descriptor->base.user_data = view; /* units that take every image leave those with user data alone */
  descriptor->src = view;
  descriptor->header.cf = SCENE_FORMAT;
  descriptor->image_area = (lv_area_t){origin.x, origin.y, area->x2, area->y2};
  lv_draw_finalize_task_creation(layer, task);
}
