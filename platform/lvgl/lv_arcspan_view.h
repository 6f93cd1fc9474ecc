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

/* For lv_arcspan_view_set_turned(): no object. */
#define LV_ARCSPAN_NO_OBJECT 0xFFFFu

LV_ATTRIBUTE_EXTERN_DATA extern const lv_obj_class_t lv_arcspan_view_class;

/* A view without a scene, before a camera at z = 3 that looks at the origin. Returns NULL if there is no
 * memory for the widget; what LVGL allocates for a draw unit and events it does not check itself. */
lv_obj_t* lv_arcspan_view_create(lv_obj_t* parent);

/* Shows a scene, or none (NULL). The former one must stay until the next refresh, or until the widget is
 * deleted. Several widgets may show one scene: when one of them turns an object of it, call
 * lv_arcspan_view_update() for the others before the next refresh, or, if that one is hidden, before the
 * refresh that shows it and after each snapshot of it. The widgets may be on other displays, if all of those
 * were created before them. */
void lv_arcspan_view_set_scene(lv_obj_t* obj, arcspan_scene* scene);
void lv_arcspan_view_set_camera(lv_obj_t* obj, const lv_arcspan_camera_t* camera);

/* Names the object that a drag over the picture, arrow keys, an encoder that edits the widget and pinches
 * turn and scale. They send LV_EVENT_VALUE_CHANGED. The widget then joins the default group, unless it is in
 * one. The object gets the rotation and the scale of the widget: none and 1 at first. With
 * LV_ARCSPAN_NO_OBJECT, the default, input does nothing.
 *
 * It gets them when a refresh starts. What must follow it in the same frame, as by arcspan_attach(), is moved
 * after that, in LV_EVENT_REFR_START | LV_EVENT_PREPROCESS of the display, by a callback that is added after
 * the widget was made. */
void lv_arcspan_view_set_turned(lv_obj_t* obj, arcspan_object object);
void lv_arcspan_view_set_rotation(lv_obj_t* obj, arcspan_quaternion rotation);
arcspan_quaternion lv_arcspan_view_get_rotation(const lv_obj_t* obj);
void lv_arcspan_view_set_scale(lv_obj_t* obj, arcspan_length scale);
arcspan_length lv_arcspan_view_get_scale(const lv_obj_t* obj);

/* Smooths outlines, and draws them as lines of ink unless `ink` is NULL, with memory of lv_malloc() for
 * `limits`; not any more if that is NULL. The models must be written by `arcspan mesh --outlines`, or
 * --curved-outlines for curves. The scene is then drawn through layers that are larger than what they show by
 * one or two pixels on all sides, over any background. If a limit is reached, a part has no neighbours or a
 * curve no room, the scene is shown less smooth, and lv_arcspan_view_get_status() says why:
 * ARCSPAN_BUFFER_TOO_SMALL, ARCSPAN_UNSUPPORTED or ARCSPAN_SCALE_OUT_OF_RANGE. Returns
 *
 *   ARCSPAN_INVALID_ARGUMENT   the width of the ink is out of range
 *   ARCSPAN_UNSUPPORTED        without ARCSPAN_C_OUTLINES and ARCSPAN_C_ARGB8888, or ARCSPAN_C_INK for ink */
arcspan_status lv_arcspan_view_set_outlines(lv_obj_t* obj, const arcspan_outline_limits* limits,
                                            const arcspan_ink* ink);

/* To be called after a change of the scene itself, by a function of arcspan.h: it is then drawn anew. */
void lv_arcspan_view_update(lv_obj_t* obj);

/* The view of the last frame, for arcspan_pick() and arcspan_project(), with pixels from the corner of the
 * content area on; NULL before. It is valid until the next refresh. */
arcspan_view* lv_arcspan_view_get_view(const lv_obj_t* obj);

/* ARCSPAN_OK, or why the last frame is not shown, or a rectangle of it is missing or not as smooth as asked
 * for; ARCSPAN_NOT_READY without a scene or a content area. */
arcspan_status lv_arcspan_view_get_status(const lv_obj_t* obj);
/* How many frames and rectangles have not been drawn since the widget was made. For lack of memory
 * (ARCSPAN_BUFFER_TOO_SMALL) the widget asks for another refresh, which tries again; for another reason after
 * the next change. */
uint32_t lv_arcspan_view_get_dropped(const lv_obj_t* obj);

#ifdef __cplusplus
}
#endif

#endif
