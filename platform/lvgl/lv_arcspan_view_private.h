/* SPDX-License-Identifier: MIT */
#ifndef LV_ARCSPAN_VIEW_PRIVATE_H
#define LV_ARCSPAN_VIEW_PRIVATE_H

#include "lv_arcspan_view.h"

#include <arcspan_config.h>

/* Widgets and draw units outside of LVGL need its private headers, which change between minor versions. */
#include <src/lvgl_private.h>

#if LVGL_VERSION_MAJOR != 9 || LVGL_VERSION_MINOR != 6
#error "platform/lvgl is for LVGL 9.6"
#endif

/* Smooth outlines are drawn through layers of this format. */
#define LV_ARCSPAN_OUTLINES (ARCSPAN_C_OUTLINES && ARCSPAN_C_ARGB8888)

typedef struct {
  lv_obj_t obj;
  arcspan_scene* scene;
  void* view_memory;
  arcspan_view* view;         /* in view_memory; NULL before the first frame, and without memory for one */
  arcspan_view_limits limits; /* of `view` */
  const arcspan_scene* seen;  /* by `view` */
  lv_arcspan_camera_t camera;
  arcspan_quaternion rotation;
  arcspan_length scale;
  arcspan_object turned;
  arcspan_status status;
  arcspan_status turn_status; /* of turning the object for this refresh, if is_turned */
  bool changed;               /* since the last frame */
  bool is_refreshing;         /* the display is being refreshed */
  bool is_turned;             /* the object was turned before this refresh */
  uint32_t turned_at;         /* is_turned: the turns by views of other displays until then */
  lv_area_t shown;            /* by the frame on the screen, from the widget's corner on; empty if x1 > x2 */
  lv_area_t inset;    /* of the picture of the last frame from the sides of the widget, as positive numbers */
  arcspan_rect drawn; /* by the last frame, in the picture; empty if it is not shown */
  uint32_t dropped;
#if LV_ARCSPAN_OUTLINES
  arcspan_outline_limits outline_limits; /* as asked for; no triangles: none */
  arcspan_ink ink;                       /* of width 0: none */
  bool outlines_changed;                 /* since outline_memory was allocated */
  void* outline_memory;
  uint8_t more; /* pixels of a layer around what it shows in the last frame; 0 without outlines */
#endif
#if LV_USE_GESTURE_RECOGNITION
  bool several_fingers;       /* since the first of them was put down, there were more than one */
  bool pinched;               /* a pinch is under way */
  arcspan_length pinch_scale; /* the scale at its beginning */
#endif
} lv_arcspan_view_t;

/* Counts a frame or a rectangle that is not drawn; for lack of memory it is tried again. */
void lv_arcspan_view_drop(lv_arcspan_view_t* view, arcspan_status status);

/* Queues the drawing of the last frame of `view`, whose picture begins at `origin`: an image task whose
 * source is the widget. */
void lv_arcspan_unit_add_task(lv_layer_t* layer, lv_arcspan_view_t* view, const lv_area_t* area,
                              lv_point_t origin);

/* Registers the draw unit, unless it is. */
void lv_arcspan_unit_init(void);

#endif
