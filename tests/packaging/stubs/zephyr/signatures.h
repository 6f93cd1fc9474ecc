// SPDX-License-Identifier: MIT
// The public signatures of Zephyr that examples/zephyr uses, of version 4.1 or 4.4. Nothing is implemented.
// Compared with display.h at 02611d7c, display_stm32_ltdc.c at 002681b1 and the guides for migration to 4.3
// and 4.4; not with other displays' drivers.
#pragma once
#include <errno.h>
#include <stdint.h>

#define ZEPHYR_VERSION(a, b, c) (((a) << 16) + ((b) << 8) + (c))
#ifndef ZEPHYR_VERSION_CODE
#define ZEPHYR_VERSION_CODE ZEPHYR_VERSION(4, 4, 0)
#endif

extern "C" {
struct device {
  const char* name;
};
extern const struct device display_stub;
#define DT_CHOSEN(name) name##_stub
#define zephyr_display_stub display_stub
#define DEVICE_DT_GET(node) (&node)
bool device_is_ready(const struct device* dev);

enum display_pixel_format {
  PIXEL_FORMAT_RGB_888 = 1,
  PIXEL_FORMAT_MONO01 = 2,
  PIXEL_FORMAT_MONO10 = 4,
  PIXEL_FORMAT_ARGB_8888 = 8,
  PIXEL_FORMAT_RGB_565 = 16,
#if ZEPHYR_VERSION_CODE >= ZEPHYR_VERSION(4, 4, 0)
  PIXEL_FORMAT_RGB_565X = 32,
#else
  PIXEL_FORMAT_BGR_565 = 32,
#endif
};
enum display_orientation { DISPLAY_ORIENTATION_NORMAL };
struct display_capabilities {
  uint16_t x_resolution;
  uint16_t y_resolution;
  uint32_t supported_pixel_formats;
  uint32_t screen_info;
  enum display_pixel_format current_pixel_format;
  enum display_orientation current_orientation;
};
struct display_buffer_descriptor {
  uint32_t buf_size;
  uint16_t width;
  uint16_t height;
  uint16_t pitch;
  bool frame_incomplete;
};
void display_get_capabilities(const struct device* dev, struct display_capabilities* capabilities);
int display_set_pixel_format(const struct device* dev, const enum display_pixel_format pixel_format);
int display_blanking_off(const struct device* dev);
int display_write(const struct device* dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor* desc, const void* buf);

void log_error(const char* format, ...) __attribute__((format(printf, 1, 2)));
#define LOG_MODULE_REGISTER(name) static_assert(true)
#define LOG_ERR(...) log_error(__VA_ARGS__)
}
