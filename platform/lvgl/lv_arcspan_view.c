/* SPDX-License-Identifier: MIT */
#include "lv_arcspan_view_private.h"

#define VIEW_CLASS (&lv_arcspan_view_class)

/* A key or a step of an encoder turns by as much as a drag over this part of the picture. */
#define KEY_STEPS 16

static void constructor(const lv_obj_class_t* class_p, lv_obj_t* obj);
static void destructor(const lv_obj_class_t* class_p, lv_obj_t* obj);
static void event(const lv_obj_class_t* class_p, lv_event_t* e);

const lv_obj_class_t lv_arcspan_view_class = {
    .base_class = &lv_obj_class,
    .constructor_cb = constructor,
    .destructor_cb = destructor,
    .event_cb = event,
    .width_def = LV_DPI_DEF,
    .height_def = LV_DPI_DEF,
    .editable = LV_OBJ_CLASS_EDITABLE_TRUE,
    .instance_size = sizeof(lv_arcspan_view_t),
    .name = "lv_arcspan_view",
};

/* The picture of the last frame on the screen. Styles are asked once per frame, because that takes long. */
static lv_area_t picture_area(const lv_arcspan_view_t* view) {
  const lv_area_t* const widget = &view->obj.coords;
  const lv_area_t* const inset = &view->inset;
  return (lv_area_t){widget->x1 + inset->x1, widget->y1 + inset->y1, widget->x2 - inset->x2,
                     widget->y2 - inset->y2};
}

static void measure_picture(lv_arcspan_view_t* view) {
  const lv_area_t* const widget = &view->obj.coords;
  lv_area_t area;
  lv_obj_get_content_coords(&view->obj, &area);
  view->inset =
      (lv_area_t){area.x1 - widget->x1, area.y1 - widget->y1, widget->x2 - area.x2, widget->y2 - area.y2};
}

/* The rectangle of the last frame on the screen. Returns false if it is empty. */
static bool drawn_area(const lv_arcspan_view_t* view, lv_area_t* area) {
  const lv_area_t picture = picture_area(view);
  const arcspan_rect* const drawn = &view->drawn;
  *area = (lv_area_t){picture.x1 + drawn->left, picture.y1 + drawn->top, picture.x1 + drawn->right - 1,
                      picture.y1 + drawn->bottom - 1};
  return drawn->left < drawn->right && drawn->top < drawn->bottom;
}

static void invalidate_shown(lv_arcspan_view_t* view) {
  lv_area_t area = view->shown;
  if (area.x1 > area.x2) return;
  lv_area_move(&area, view->obj.coords.x1, view->obj.coords.y1);
  lv_obj_invalidate_area(&view->obj, &area);
}

/* Takes the rectangle of the prepared frame for `shown`, and invalidates it. */
static void show_drawn(lv_arcspan_view_t* view) {
  if (!drawn_area(view, &view->shown))
    view->shown = (lv_area_t){0, 0, -1, -1};
  else
    lv_area_move(&view->shown, -view->obj.coords.x1, -view->obj.coords.y1);
  invalidate_shown(view);
}

/* Frames */

/* Asks for a refresh, in which the frame is prepared. Nothing is invalidated now, because a frame may be
 * under way. */
static void change(lv_arcspan_view_t* view) {
  view->changed = true;
  lv_display_send_event(lv_obj_get_display(&view->obj), LV_EVENT_REFR_REQUEST, NULL);
}

/* change(), after which the object has to be turned anew, also if it was for this refresh. */
static void change_object(lv_arcspan_view_t* view) {
  view->is_turned = false;
  change(view);
}

void lv_arcspan_view_drop(lv_arcspan_view_t* view, arcspan_status status) {
  view->status = status;
  ++view->dropped;
  if (status == ARCSPAN_BUFFER_TOO_SMALL) change(view); /* other failures await a change */
  LV_LOG_WARN("arcspan: a frame or a rectangle of it is not drawn: %s", arcspan_status_text(status));
}

static void free_view(lv_arcspan_view_t* view) {
  lv_free(view->view_memory);
  view->view_memory = NULL;
  view->view = NULL;
}

/* Makes memory for all objects that the scene has now. */
static arcspan_status make_view(lv_arcspan_view_t* view) {
  arcspan_view_limits limits = arcspan_limits_of(view->scene, 0);
  const bool has_room = view->view != NULL && view->seen == view->scene &&
                        view->limits.objects >= limits.objects && view->limits.vertices >= limits.vertices;
  if (has_room) return ARCSPAN_OK;
  free_view(view);
  view->seen = view->scene;
  /* A frame is drawn in several rectangles. If there is memory, each vertex is transformed once for all. */
  const arcspan_view_limits least = limits;
  limits = arcspan_limits_of(view->scene, 1);
  size_t bytes = arcspan_view_bytes(&limits);
  view->view_memory = lv_malloc(bytes);
  if (view->view_memory == NULL) { /* rather without rows than without vertices */
    limits.triangles = 0;
    bytes = arcspan_view_bytes(&limits);
    view->view_memory = lv_malloc(bytes);
  }
  if (view->view_memory == NULL) {
    limits = least;
    bytes = arcspan_view_bytes(&limits);
    view->view_memory = lv_malloc(bytes);
  }
  view->limits = limits;
  return arcspan_view_make(view->view_memory, bytes, &limits, view->scene, &view->view);
}

static arcspan_status set_camera(lv_arcspan_view_t* view) {
  const lv_area_t picture = picture_area(view);
  const lv_arcspan_camera_t* const camera = &view->camera;
  const int32_t width = lv_area_get_width(&picture);
  const int32_t height = lv_area_get_height(&picture);
  if (width > UINT16_MAX || height > UINT16_MAX) return ARCSPAN_INVALID_ARGUMENT;
  const arcspan_lens lens = {(uint16_t)width, (uint16_t)height, camera->angle,
                             camera->extent,  camera->nearest,  camera->farthest};
  return arcspan_set_camera(view->view, &lens, camera->eye, camera->target, camera->up);
}

/* How often a view turned its object for the refresh of another display. */
static uint32_t foreign_turns;

static arcspan_status turn_object(lv_arcspan_view_t* view) {
  if (view->turned == LV_ARCSPAN_NO_OBJECT) return ARCSPAN_OK;
  const arcspan_status status = arcspan_set_quaternion(view->scene, view->turned, view->rotation);
  return status == ARCSPAN_OK ? arcspan_set_scale(view->scene, view->turned, view->scale) : status;
}

#if LV_ARCSPAN_OUTLINES

/* Gives the view memory for the outlines that are asked for, and ink. */
static arcspan_status give_outlines(lv_arcspan_view_t* view) {
  const arcspan_outline_limits* const limits = &view->outline_limits;
  const arcspan_ink* const ink = &view->ink;
  const size_t bytes = limits->triangles != 0 ? arcspan_outline_bytes(limits) : 0;
  if (view->outlines_changed) {
    lv_free(view->outline_memory);
    view->outline_memory = bytes != 0 ? lv_malloc(bytes) : NULL;
    view->outlines_changed = bytes != 0 && view->outline_memory == NULL; /* tried again by the next frame */
  }
  arcspan_status status = arcspan_smooth_outlines(view->view, view->outline_memory, bytes, limits);
  if (view->outline_memory == NULL) {
    view->more = 0;
    return view->outlines_changed ? ARCSPAN_BUFFER_TOO_SMALL : status;
  }
  view->more = ink->width != 0 && ink->creases ? 2 : 1;
#if ARCSPAN_C_INK
  if (status == ARCSPAN_OK) status = arcspan_ink_outlines(view->view, ink->width != 0 ? ink : NULL);
#endif
  return status;
}

static int32_t pixels_more(const lv_arcspan_view_t* view) { return view->more; }

#else

static arcspan_status give_outlines(lv_arcspan_view_t* view) {
  LV_UNUSED(view);
  return ARCSPAN_OK;
}

static int32_t pixels_more(const lv_arcspan_view_t* view) {
  LV_UNUSED(view);
  return 0;
}

#endif

/* Prepares the frame that is drawn from now on. */
static void prepare(lv_arcspan_view_t* view) {
  view->changed = false;
  view->drawn = (arcspan_rect){0, 0, 0, 0};
  view->status = ARCSPAN_NOT_READY;
  if (view->scene == NULL) {
    free_view(view);
    return;
  }
  measure_picture(view);
  const lv_area_t picture = picture_area(view);
  if (picture.x2 < picture.x1 || picture.y2 < picture.y1) return;
  view->status = make_view(view);
  if (view->status == ARCSPAN_OK) view->status = set_camera(view);
  const bool is_turned = view->is_turned && view->turned_at == foreign_turns;
  if (view->status == ARCSPAN_OK) view->status = is_turned ? view->turn_status : turn_object(view);
  if (view->status == ARCSPAN_OK) view->status = give_outlines(view);
  if (view->status == ARCSPAN_OK) view->status = arcspan_prepare(view->view);
  if (view->status == ARCSPAN_OK) {
    view->drawn = arcspan_drawn_rect(view->view);
    return;
  }
  lv_arcspan_view_drop(view, view->status);
}

static bool is_own_refresh(lv_event_t* e, const lv_arcspan_view_t* view) {
  return lv_event_get_current_target(e) == lv_obj_get_display(&view->obj);
}

/* Before any view prepares its frame: layouts may change sizes, and a view without a size does not turn its
 * object, which views of any display may show. Events of a layout may delete the view: nothing follows it. */
static void lay_out(lv_event_t* e) {
  lv_arcspan_view_t* const view = lv_event_get_user_data(e);
  if (is_own_refresh(e, view) || (view->changed && !view->is_refreshing)) lv_obj_update_layout(&view->obj);
}

static void before_refresh(lv_event_t* e) {
  lv_arcspan_view_t* const view = lv_event_get_user_data(e);
  const bool is_own = is_own_refresh(e, view);
  if (!is_own && view->is_refreshing) return; /* its frame is being drawn */
  /* A hidden view leaves the object to the visible one, as of another tab. */
  const bool turns = view->changed && view->scene != NULL && lv_obj_is_visible(&view->obj);
  if (turns) view->turn_status = turn_object(view);
  if (turns && !is_own) ++foreign_turns;
  view->is_turned = turns && is_own;
  view->turned_at = foreign_turns;
}

/* Of the display, before it finds out what to draw. */
static void on_refresh_start(lv_event_t* e) {
  lv_arcspan_view_t* const view = lv_event_get_user_data(e);
  view->is_refreshing = true;
  if (!view->changed) return;
  if (!lv_obj_is_visible(&view->obj)) {
    if (view->seen != view->scene) free_view(view); /* of a scene that need not stay any longer */
    return;
  }
  invalidate_shown(view);
  prepare(view);
  show_drawn(view);
}

static void on_refresh_end(lv_event_t* e) {
  lv_arcspan_view_t* const view = lv_event_get_user_data(e);
  view->is_refreshing = false;
  view->is_turned = false;
}

/* Drawing */

/* Styles of the view, or of what holds it, lay a colour over it: LVGL's theme does so if that is disabled. */
static bool is_recoloured(const lv_layer_t* layer) {
  return ARCSPAN_C_ARGB8888 && layer->recolor.alpha > LV_OPA_MIN;
}

/* Draws the part of the scene in `strip` in a layer, and the layer with an opacity, the colour that styles
 * lay over it and, unless `radius` is 0, with the round corners of `corners`. */
static void add_layer(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* strip, lv_opa_t opa,
                      const lv_area_t* corners, int32_t radius) {
  const lv_area_t picture = picture_area(view);
  lv_layer_t* const scene = lv_draw_layer_create(layer, LV_COLOR_FORMAT_ARGB8888, strip);
  if (scene == NULL) {
    lv_arcspan_view_drop(view, ARCSPAN_BUFFER_TOO_SMALL);
    return;
  }
  scene->opa = LV_OPA_COVER;
  lv_arcspan_unit_add_task(scene, view, strip, (lv_point_t){picture.x1, picture.y1});
  if (radius > 0) {
    lv_draw_mask_rect_dsc_t mask;
    lv_draw_mask_rect_dsc_init(&mask);
    mask.area = *corners;
    mask.radius = radius;
    lv_draw_mask_rect(scene, &mask);
  }
  lv_draw_image_dsc_t descriptor;
  lv_draw_image_dsc_init(&descriptor);
  descriptor.base.obj = &view->obj;
  descriptor.src = scene;
  descriptor.opa = opa;
  descriptor.recolor = lv_color_make(layer->recolor.red, layer->recolor.green, layer->recolor.blue);
  descriptor.recolor_opa = layer->recolor.alpha;
  lv_draw_layer(layer, &descriptor, strip);
}

#if LV_ARCSPAN_OUTLINES
/* The same through a layer that has the pixels around the strip, too, on which its outlines depend. */
static void add_strip(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* strip, lv_opa_t opa,
                      const lv_area_t* corners, int32_t radius) {
  lv_area_t drawn; /* all that outlines depend on and change */
  (void)drawn_area(view, &drawn);
  lv_area_t held = *strip;
  lv_area_increase(&held, view->more, view->more);
  (void)lv_area_intersect(&held, &held, &drawn);
  const lv_area_t clip = layer->_clip_area;
  layer->_clip_area = *strip;
  add_layer(layer, view, &held, opa, corners, radius);
  layer->_clip_area = clip;
}
#else
#define add_strip add_layer
#endif

/* The same in strips, whose layers are as large as those that LVGL allocates for its own. */
static void add_layers(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* area, lv_opa_t opa,
                       const lv_area_t* corners, int32_t radius) {
  const int32_t more = 2 * pixels_more(view); /* on both sides */
  int32_t rows = LV_DRAW_LAYER_SIMPLE_BUF_SIZE / (4 * (lv_area_get_width(area) + more)) - more;
  if (rows < 1) rows = 1;
  lv_area_t strip = *area;
  for (; strip.y1 <= area->y2; strip.y1 += rows) {
    strip.y2 = LV_MIN(strip.y1 + rows - 1, area->y2);
    add_strip(layer, view, &strip, opa, corners, radius);
  }
}

/* The edge, and its radius, that clip_corner clips by: the inner one of a border that has all sides. */
static int32_t corner_radius(const lv_obj_t* obj, lv_area_t* corners) {
  lv_area_copy(corners, &obj->coords);
  if (!lv_obj_get_style_clip_corner(obj, LV_PART_MAIN)) return 0;
  const lv_border_side_t sides = lv_obj_get_style_border_side(obj, LV_PART_MAIN) & LV_BORDER_SIDE_FULL;
  const int32_t border = sides == LV_BORDER_SIDE_FULL ? lv_obj_get_style_border_width(obj, LV_PART_MAIN) : 0;
  const int32_t shorter = LV_MIN(lv_area_get_width(corners), lv_area_get_height(corners));
  const int32_t radius = LV_MIN(lv_obj_get_style_radius(obj, LV_PART_MAIN), shorter / 2) - border;
  lv_area_increase(corners, -border, -border);
  return LV_MAX(radius, 0);
}

/* Draws the rows of `area` from `top` to `bottom` straight, or with round corners if `radius` is not 0. */
static void add_rows(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* area, int32_t top,
                     int32_t bottom, const lv_area_t* corners, int32_t radius) {
  lv_area_t rows = *area;
  rows.y1 = LV_MAX(area->y1, top);
  rows.y2 = LV_MIN(area->y2, bottom);
  if (rows.y1 > rows.y2) return;
  const bool is_cut = radius > 0 && (rows.x1 < corners->x1 + radius || rows.x2 > corners->x2 - radius);
  if (is_cut) {
    add_layers(layer, view, &rows, LV_OPA_COVER, corners, radius);
  } else {
    const lv_area_t picture = picture_area(view);
    lv_arcspan_unit_add_task(layer, view, &rows, (lv_point_t){picture.x1, picture.y1});
  }
}

static void draw_main(lv_event_t* e) {
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)lv_event_get_current_target_obj(e);
  lv_layer_t* const layer = lv_event_get_layer(e);
  lv_arcspan_unit_init(); /* lv_deinit() may have freed it */
  if (view->changed && (!view->is_refreshing || view->view == NULL)) {
    prepare(view);        /* for lv_snapshot_take(), for example */
    view->changed = true; /* the screen still shows another frame */
  }
  lv_area_t area;
  if (!drawn_area(view, &area) || !lv_area_intersect(&area, &area, &layer->_clip_area)) return;
  const lv_opa_t opa =
      layer->opa; /* LVGL's own: in a snapshot without that of its object and of what holds it */
  if (opa <= LV_OPA_MIN) return;
  lv_area_t corners;
  const int32_t radius = corner_radius(&view->obj, &corners);
  if (opa < LV_OPA_MAX || is_recoloured(layer) || pixels_more(view) != 0) {
    add_layers(layer, view, &area, opa, &corners, radius);
    return;
  }
  add_rows(layer, view, &area, area.y1, corners.y1 + radius - 1, &corners, radius);
  add_rows(layer, view, &area, corners.y1 + radius, corners.y2 - radius, &corners, 0);
  add_rows(layer, view, &area, corners.y2 - radius + 1, area.y2, &corners, radius);
}

/* Input */

static void turn_by_user(lv_arcspan_view_t* view, int32_t dx, int32_t dy) {
  if (view->turned == LV_ARCSPAN_NO_OBJECT || view->view == NULL || (dx == 0 && dy == 0)) return;
  lv_arcspan_view_set_rotation(&view->obj, arcspan_dragged(view->view, view->rotation, dx, dy));
  lv_obj_send_event(&view->obj, LV_EVENT_VALUE_CHANGED, NULL);
}

static void on_drag(lv_arcspan_view_t* view) {
  lv_indev_t* const indev = lv_indev_active();
  if (indev == NULL) return;
#if LV_USE_GESTURE_RECOGNITION
  /* Until all fingers are lifted, the point may be that of any of them. */
  const lv_indev_gesture_t* const fingers = indev->recognizers[LV_INDEV_GESTURE_PINCH].info;
  if (fingers != NULL && fingers->finger_cnt > 1) view->several_fingers = true;
  if (view->several_fingers) return;
#endif
  lv_point_t moved;
  lv_indev_get_vect(indev, &moved);
  lv_point_t at;
  lv_indev_get_point(indev, &at);
  /* Both points, not their difference, so that rounding errors do not add up. */
  lv_point_t points[] = {{at.x - moved.x, at.y - moved.y}, at};
  lv_obj_transform_point_array(&view->obj, points, 2, LV_OBJ_POINT_TRANSFORM_FLAG_INVERSE_RECURSIVE);
  turn_by_user(view, points[1].x - points[0].x, points[1].y - points[0].y);
}

static void on_key(lv_arcspan_view_t* view, uint32_t key) {
  const lv_area_t picture = picture_area(view);
  const int32_t step = LV_MIN(lv_area_get_width(&picture), lv_area_get_height(&picture)) / KEY_STEPS;
  const int32_t dx = key == LV_KEY_RIGHT ? step : key == LV_KEY_LEFT ? -step : 0;
  const int32_t dy = key == LV_KEY_DOWN ? step : key == LV_KEY_UP ? -step : 0;
  turn_by_user(view, dx, dy);
}

static void on_rotary(lv_arcspan_view_t* view, int32_t steps) {
  const lv_area_t picture = picture_area(view);
  turn_by_user(view, steps * lv_area_get_width(&picture) / KEY_STEPS, 0);
}

#if LV_USE_GESTURE_RECOGNITION
/* The scale of a pinch is relative to its beginning. */
static void on_gesture(lv_arcspan_view_t* view, lv_event_t* e) {
  if (view->turned == LV_ARCSPAN_NO_OBJECT || lv_event_get_gesture_type(e) != LV_INDEV_GESTURE_PINCH) return;
  const lv_indev_gesture_state_t state = lv_event_get_gesture_state(e, LV_INDEV_GESTURE_PINCH);
  if (!view->pinched) view->pinch_scale = view->scale;
  view->pinched = state == LV_INDEV_GESTURE_STATE_RECOGNIZED;
  const float scale = (float)view->pinch_scale * lv_event_get_pinch_scale(e);
  if (!(scale >= 64.0F && scale <= 2147483520.0F)) return; /* the range of arcspan_set_scale() */
  lv_arcspan_view_set_scale(&view->obj, (arcspan_length)scale);
  lv_obj_send_event(&view->obj, LV_EVENT_VALUE_CHANGED, NULL);
}
#endif

/* The class */

static void constructor(const lv_obj_class_t* class_p, lv_obj_t* obj) {
  LV_UNUSED(class_p);
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  view->camera = (lv_arcspan_camera_t){.angle = ARCSPAN_DEGREES(45),
                                       .nearest = ARCSPAN_LENGTH(1),
                                       .farthest = ARCSPAN_LENGTH(16),
                                       .eye = {0, 0, ARCSPAN_LENGTH(3)}};
  view->rotation = (arcspan_quaternion){1 << 30, 0, 0, 0};
  view->scale = ARCSPAN_LENGTH(1);
  view->turned = LV_ARCSPAN_NO_OBJECT;
  view->status = ARCSPAN_NOT_READY;
  view->shown = (lv_area_t){0, 0, -1, -1};
  lv_obj_set_scrollable(obj, false);
  lv_display_t* const display = lv_obj_get_display(obj);
  for (lv_display_t* any = lv_display_get_next(NULL); any != NULL; any = lv_display_get_next(any)) {
    /* A view of another display may show the object. */
    lv_display_add_event_cb(any, lay_out, LV_EVENT_REFR_START | LV_EVENT_PREPROCESS, view);
    lv_display_add_event_cb(any, before_refresh, LV_EVENT_REFR_START | LV_EVENT_PREPROCESS, view);
  }
  lv_display_add_event_cb(display, on_refresh_start, LV_EVENT_REFR_START, view);
  lv_display_add_event_cb(display, on_refresh_end, LV_EVENT_REFR_READY, view);
}

static void destructor(const lv_obj_class_t* class_p, lv_obj_t* obj) {
  LV_UNUSED(class_p);
  /* Of all displays, because its parent may have changed. */
  for (lv_display_t* display = lv_display_get_next(NULL); display != NULL;
       display = lv_display_get_next(display)) {
    lv_display_remove_event_cb_with_user_data(display, lay_out, obj);
    lv_display_remove_event_cb_with_user_data(display, before_refresh, obj);
    lv_display_remove_event_cb_with_user_data(display, on_refresh_start, obj);
    lv_display_remove_event_cb_with_user_data(display, on_refresh_end, obj);
  }
  free_view((lv_arcspan_view_t*)obj);
#if LV_ARCSPAN_OUTLINES
  lv_free(((lv_arcspan_view_t*)obj)->outline_memory);
#endif
}

static void event(const lv_obj_class_t* class_p, lv_event_t* e) {
  LV_UNUSED(class_p);
  if (lv_obj_event_base(VIEW_CLASS, e) != LV_RESULT_OK) return;
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)lv_event_get_current_target_obj(e);
  switch (lv_event_get_code(e)) {
    case LV_EVENT_DRAW_MAIN:
      draw_main(e);
      break;
    case LV_EVENT_SIZE_CHANGED:
    case LV_EVENT_STYLE_CHANGED:
      change(view);
      break;
#if LV_USE_GESTURE_RECOGNITION
    case LV_EVENT_PRESSED:
    case LV_EVENT_PRESS_LOST:
    case LV_EVENT_RELEASED:
      view->several_fingers = false;
      view->pinched = false; /* the end of the last pinch may have been sent to none */
      break;
#endif
    case LV_EVENT_PRESSING:
      on_drag(view);
      break;
    case LV_EVENT_KEY:
      on_key(view, lv_event_get_key(e));
      break;
    case LV_EVENT_ROTARY:
      on_rotary(view, lv_event_get_rotary_diff(e));
      break;
#if LV_USE_GESTURE_RECOGNITION
    case LV_EVENT_GESTURE:
      on_gesture(view, e);
      break;
#endif
    default:
      break;
  }
}

/* The interface */

lv_obj_t* lv_arcspan_view_create(lv_obj_t* parent) {
  lv_arcspan_unit_init();
  lv_obj_t* const obj = lv_obj_class_create_obj(VIEW_CLASS, parent);
  if (obj != NULL) lv_obj_class_init_obj(obj);
  return obj;
}

void lv_arcspan_view_set_scene(lv_obj_t* obj, arcspan_scene* scene) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  view->scene = scene; /* the frame of the former one may still be drawn */
  change_object(view);
}

void lv_arcspan_view_set_camera(lv_obj_t* obj, const lv_arcspan_camera_t* camera) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  view->camera = *camera;
  change(view);
}

void lv_arcspan_view_set_turned(lv_obj_t* obj, arcspan_object object) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  const bool is_turned = object != LV_ARCSPAN_NO_OBJECT;
  if (is_turned && view->turned == LV_ARCSPAN_NO_OBJECT && lv_obj_get_group(obj) == NULL &&
      lv_group_get_default() != NULL) {
    lv_group_add_obj(lv_group_get_default(), obj);
  }
  view->turned = object;
  lv_obj_set_scroll_chain(obj, !is_turned);
  change_object(view);
}

void lv_arcspan_view_set_rotation(lv_obj_t* obj, arcspan_quaternion rotation) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  view->rotation = rotation;
  change_object(view);
}

arcspan_quaternion lv_arcspan_view_get_rotation(const lv_obj_t* obj) {
  return ((const lv_arcspan_view_t*)obj)->rotation;
}

void lv_arcspan_view_set_scale(lv_obj_t* obj, arcspan_length scale) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  view->scale = scale;
  change_object(view);
}

arcspan_length lv_arcspan_view_get_scale(const lv_obj_t* obj) {
  return ((const lv_arcspan_view_t*)obj)->scale;
}

arcspan_status lv_arcspan_view_set_outlines(lv_obj_t* obj, const arcspan_outline_limits* limits,
                                            const arcspan_ink* ink) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return ARCSPAN_INVALID_ARGUMENT);
#if LV_ARCSPAN_OUTLINES
  lv_arcspan_view_t* const view = (lv_arcspan_view_t*)obj;
  if (ink != NULL && !ARCSPAN_C_INK) return ARCSPAN_UNSUPPORTED;
  if (ink != NULL && (ink->width < 1 || ink->width > 4)) return ARCSPAN_INVALID_ARGUMENT;
  view->outline_limits = limits != NULL ? *limits : (arcspan_outline_limits){0, 0, 0, 0};
  view->ink = ink != NULL ? *ink : (arcspan_ink){{0, 0, 0}, 0, 0};
  view->outlines_changed = true;
  change(view); /* the frame that may be under way keeps its memory */
  return ARCSPAN_OK;
#else
  LV_UNUSED(obj);
  LV_UNUSED(limits);
  LV_UNUSED(ink);
  return ARCSPAN_UNSUPPORTED;
#endif
}

void lv_arcspan_view_update(lv_obj_t* obj) {
  LV_CHECK_OBJ(obj, VIEW_CLASS, return );
  change((lv_arcspan_view_t*)obj);
}

arcspan_view* lv_arcspan_view_get_view(const lv_obj_t* obj) { return ((const lv_arcspan_view_t*)obj)->view; }

arcspan_status lv_arcspan_view_get_status(const lv_obj_t* obj) {
  return ((const lv_arcspan_view_t*)obj)->status;
}

uint32_t lv_arcspan_view_get_dropped(const lv_obj_t* obj) { return ((const lv_arcspan_view_t*)obj)->dropped; }
