/* SPDX-License-Identifier: MIT */
/* lv_arcspan_view, a widget of LVGL 9.6 that shows an arcspan scene. Its picture is drawn straight into
 * LVGL's draw buffers, behind its children and over its background. docs/lvgl.md has an example.
 *
 * The picture is the widget's content area, inside of border and padding. Only the rectangle that the scene
 * covers is invalidated, before and after a change, once per refresh; while the widget is hidden nothing is
 * done. Functions may be called from where LVGL's may: in its thread, also in events, but not while a frame
 * is being drawn (the events LV_EVENT_DRAW_...). */
#ifndef LV_ARCSPAN_VIEW_H
#define LV_ARCSPAN_VIEW_H

#include <arcspan.h>
#include <lvgl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The camera of a view: arcspan_lens without the size of the picture, and where it stands. */
typedef struct {
  arcspan_turn angle;
  arcspan_length extent;
  arcspan_length nearest, farthest;
  arcspan_point eye, target, up;
} lv_arcspan_camera_t;

/* The object that drags, keys and pinches turn and scale, if nothing is set. */
#define LV_ARCSPAN_NO_OBJECT 0xFFFFu

LV_ATTRIBUTE_EXTERN_DATA extern const lv_obj_class_t lv_arcspan_view_class;

/* A view without a scene, before a camera at z = 3 that looks at the origin. Returns NULL if there is no
 * memory. */
lv_obj_t* lv_arcspan_view_create(lv_obj_t* parent);

/* Shows a scene, which must stay until another one or NULL is shown or the widget is deleted. Several widgets
 * may show one scene. */
void lv_arcspan_view_set_scene(lv_obj_t* obj, arcspan_scene* scene);
void lv_arcspan_view_set_camera(lv_obj_t* obj, const lv_arcspan_camera_t* camera);

/* Names the object that a drag over the picture, arrow keys, an encoder that edits the widget and pinches
 * turn and scale. They send LV_EVENT_VALUE_CHANGED. LV_ARCSPAN_NO_OBJECT, the default, leaves input alone.
 * The object gets the rotation and the scale of the widget: none and 1 at first. */
void lv_arcspan_view_set_turned(lv_obj_t* obj, arcspan_object object);
void lv_arcspan_view_set_rotation(lv_obj_t* obj, arcspan_quaternion rotation);
arcspan_quaternion lv_arcspan_view_get_rotation(const lv_obj_t* obj);
void lv_arcspan_view_set_scale(lv_obj_t* obj, arcspan_length scale);
arcspan_length lv_arcspan_view_get_scale(const lv_obj_t* obj);

/* To be called after a change of the scene itself, by a function of arcspan.h: it is then drawn anew. */
void lv_arcspan_view_update(lv_obj_t* obj);

/* The status of the last frame: ARCSPAN_OK, or why it is not shown. */
arcspan_status lv_arcspan_view_get_status(const lv_obj_t* obj);
/* How many rectangles could not be drawn, because there was no memory for depths or a layer, or for another
 * reason that lv_arcspan_view_get_status() then tells. */
uint32_t lv_arcspan_view_get_dropped(const lv_obj_t* obj);

#ifdef __cplusplus
}
#endif

#endif
