// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan.h>
#include <catch2/catch.hpp>
#include <lv_arcspan_view.h>
#include <lvgl.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

extern "C" {
extern const arcspan_model ball;
}

namespace arcspan::test {

/// How a display hands its pixels over.
struct DisplaySetting {
  lv_color_format_t format = LV_COLOR_FORMAT_RGB565;
  lv_display_render_mode_t mode = LV_DISPLAY_RENDER_MODE_PARTIAL;
  std::int32_t rows = 20;  ///< of the buffer, in partial mode
};

/// LVGL with a display of kWidth x kHeight pixels, whose contents are in `pixels`. Rows are padded to 4
/// bytes.
class Screen {
 public:
  static constexpr std::int32_t kWidth = 157;
  static constexpr std::int32_t kHeight = 110;

  explicit Screen(const DisplaySetting& setting = {});
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// What the display shows, kWidth * kHeight pixels without padding.
  std::vector<std::uint8_t> pixels;
  /// Areas that have been invalidated.
  std::vector<lv_area_t> invalidated;
  std::uint32_t flushes = 0;
  /// Called in each flush, if set.
  void (*in_flush)(void* data) = nullptr;
  void* flush_data = nullptr;

  /// Draws what is invalid.
  void refresh() { lv_refr_now(display_); }
  /// Draws all of the screen again, and returns what the display shows.
  std::vector<std::uint8_t> redrawn();
  /// The colour of a pixel, as the bytes of the format.
  [[nodiscard]] std::vector<std::uint8_t> pixel(std::int32_t x, std::int32_t y) const;
  [[nodiscard]] std::size_t pixel_bytes() const { return lv_color_format_get_size(setting_.format); }

 private:
  static void flush(lv_display_t* display, const lv_area_t* area, std::uint8_t* bytes);
  static void on_invalidate(lv_event_t* e);

  DisplaySetting setting_;
  std::vector<std::uint8_t> buffer_;
  lv_display_t* display_ = nullptr;
};

/// The ball with the neighbours of its triangles, for outlines. All edges are creases.
const arcspan_model& outlined_ball();

/// A scene of one ball.
struct BallScene {
  std::vector<unsigned char> memory;
  arcspan_scene* scene = nullptr;
  arcspan_object object = 0;

  explicit BallScene(const arcspan_model& model = ball);
};

/// A view of the ball at (20, 10) of the active screen, 100 x 80 pixels, which drags turn.
lv_obj_t* make_view(const BallScene& balls);

/// Allocations of at least so many bytes and fewer than `end` fail; 0 lets all succeed. Smaller ones never
/// do, because LVGL itself does not check them all.
void fail_allocations_from(std::size_t bytes, std::size_t end = SIZE_MAX);
/// True if so many bytes were allocated since the last call of fail_allocations_from().
[[nodiscard]] bool was_allocated(std::size_t bytes);

}  // namespace arcspan::test
