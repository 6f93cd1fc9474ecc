/* SPDX-License-Identifier: MIT */
/* LVGL as the tests of lv_arcspan_view build it: what they show, and its test module. */
#ifndef LV_CONF_H
#define LV_CONF_H

#define LV_COLOR_DEPTH 16
#ifdef ARCSPAN_LVGL_BARE /* on a board without a C library */
#define LV_USE_STDLIB_MALLOC LV_STDLIB_BUILTIN
#define LV_USE_STDLIB_STRING LV_STDLIB_BUILTIN
#define LV_USE_STDLIB_SPRINTF LV_STDLIB_BUILTIN
#define LV_MEM_SIZE (256 * 1024)
#else /* so that sanitizers see every byte */
#define LV_USE_STDLIB_MALLOC LV_STDLIB_CUSTOM
#define LV_USE_STDLIB_STRING LV_STDLIB_CLIB
#define LV_USE_STDLIB_SPRINTF LV_STDLIB_CLIB
#define LV_USE_TEST 1
#define LV_USE_TEST_SCREENSHOT_COMPARE 1
#define LV_TEST_SCREENSHOT_CREATE_REFERENCE_IMAGE 0 /* a missing reference is a failure */
#define LV_USE_LODEPNG 1
#define LV_USE_FS_STDIO 1
#define LV_FS_STDIO_LETTER 'A'
#define LV_FS_DEFAULT_DRIVER_LETTER 'A'
#define LV_USE_GESTURE_RECOGNITION 1
#define LV_USE_FLOAT 1
#define LV_USE_MATRIX 0
#define LV_USE_SNAPSHOT 1
#endif
#ifdef ARCSPAN_LVGL_THREADS
#define LV_USE_OS LV_OS_PTHREAD
#define LV_DRAW_SW_DRAW_UNIT_CNT 2
#else
#define LV_USE_OS LV_OS_NONE
#endif

#define LV_DEF_REFR_PERIOD 10
#define LV_DRAW_BUF_STRIDE_ALIGN 4
#define LV_DRAW_LAYER_SIMPLE_BUF_SIZE (8 * 1024)
#define LV_USE_LOG 0
#define LV_USE_ASSERT_NULL 1
#define LV_USE_ASSERT_MALLOC 0

#define LV_FONT_MONTSERRAT_14 1
#define LV_USE_THEME_DEFAULT 1
#define LV_USE_LABEL 1
#define LV_USE_SLIDER 1
#define LV_USE_BAR 1
#define LV_USE_IMAGE 1
#define LV_USE_CANVAS 0
#define LV_USE_ANIMIMG 0
#define LV_USE_ARC 0
#define LV_USE_ARCLABEL 0
#define LV_USE_BUTTON 0
#define LV_USE_BUTTONMATRIX 0
#define LV_USE_CALENDAR 0
#define LV_USE_CHART 0
#define LV_USE_CHECKBOX 0
#define LV_USE_DROPDOWN 0
#define LV_USE_IMAGEBUTTON 0
#define LV_USE_KEYBOARD 0
#define LV_USE_LED 0
#define LV_USE_LINE 0
#define LV_USE_LIST 0
#define LV_USE_MENU 0
#define LV_USE_MSGBOX 0
#define LV_USE_ROLLER 0
#define LV_USE_SCALE 0
#define LV_USE_SPAN 0
#define LV_USE_SPINBOX 0
#define LV_USE_SPINNER 0
#define LV_USE_SWITCH 0
#define LV_USE_TABLE 0
#define LV_USE_TABVIEW 0
#define LV_USE_TEXTAREA 0
#define LV_USE_TILEVIEW 0
#define LV_USE_WIN 0
#define LV_USE_FLEX 0
#define LV_USE_GRID 0
#define LV_BUILD_EXAMPLES 0
#define LV_USE_DEMO_WIDGETS 0

#endif
