/* SPDX-License-Identifier: MIT */
/* Frames of a turning ball between a label and a slider, the same on hosts and boards. */
#ifndef ARCSPAN_TESTS_LVGL_FRAMES_H
#define ARCSPAN_TESTS_LVGL_FRAMES_H

#include <arcspan.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LVGL_FRAMES = 5 };

/* FNV-1a of the pixels that each frame sends. To be changed only with a change of LVGL or of pixels. */
extern const uint32_t lvgl_frame_hashes[LVGL_FRAMES];

/* Starts LVGL with a display of 320x240 pixels and a buffer of 40 rows, and makes the widgets. */
arcspan_status lvgl_frames_start(void);
/* Turns the ball and refreshes the display. Returns the hash of what was sent since the last call. */
uint32_t lvgl_frames_next(void);

/* For measurements: the last frame by functions of arcspan.h alone. Returns the number of its arcspan_draw()
 * calls, 0 if its view is refused. */
uint32_t lvgl_frames_bare(void);
/* Takes the scene away, or shows it again. */
void lvgl_frames_show_scene(bool shown);
/* Refreshes what the last frame has refreshed. */
void lvgl_frames_again(void);

#ifdef __cplusplus
}
#endif

#endif
