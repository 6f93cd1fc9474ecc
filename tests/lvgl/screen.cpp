// SPDX-License-Identifier: MIT
#include <arcspan_c/model.hpp>
#include <tests/lvgl/screen.hpp>
#include <tests/support/neighbours.hpp>

#include <cstdlib>
#include <mutex>
#include <set>

namespace {
std::size_t least_failing = 0;
std::size_t end_of_failing = 0;
std::set<std::size_t> allocated;
std::mutex allocated_mutex;  // LVGL's threads allocate, too
bool fails(std::size_t bytes) {
  return least_failing != 0 && bytes >= least_failing && bytes < end_of_failing;
}
}  // namespace

// The allocator of LVGL (LV_STDLIB_CUSTOM).
extern "C" {
void lv_mem_init(void) {}
void lv_mem_deinit(void) {}
lv_mem_pool_t lv_mem_add_pool(void*, size_t) { return nullptr; }
void lv_mem_remove_pool(lv_mem_pool_t) {}
void* lv_malloc_core(size_t bytes) {
  if (fails(bytes)) return nullptr;
  {
    const std::lock_guard lock(allocated_mutex);
    allocated.insert(bytes);
  }
  return std::malloc(bytes);
}
void* lv_realloc_core(void* at, size_t bytes) { return fails(bytes) ? nullptr : std::realloc(at, bytes); }
void lv_free_core(void* at) { std::free(at); }
void lv_mem_monitor_core(lv_mem_monitor_t*) {}
lv_result_t lv_mem_test_core(void) { return LV_RESULT_OK; }
}

namespace arcspan::test {

void fail_allocations_from(std::size_t bytes, std::size_t end) {
  least_failing = bytes;
  end_of_failing = end;
  allocated.clear();
}

bool was_allocated(std::size_t bytes) { return allocated.count(bytes) != 0; }

Screen::Screen(const DisplaySetting& setting) : setting_(setting) {
  lv_init();
  display_ = lv_display_create(kWidth, kHeight);
  lv_display_set_color_format(display_, setting.format);
  pixels.assign(pixel_bytes() * kWidth * kHeight, 0xEE);
  const std::uint32_t stride = lv_draw_buf_width_to_stride(kWidth, setting.format);
  const std::int32_t rows = setting.mode == LV_DISPLAY_RENDER_MODE_PARTIAL ? setting.rows : kHeight;
  buffer_.assign(std::size_t{stride} * static_cast<std::size_t>(rows), 0);
  lv_display_set_buffers(display_, buffer_.data(), nullptr, static_cast<std::uint32_t>(buffer_.size()),
                         setting.mode);
  lv_display_set_user_data(display_, this);
  lv_display_set_flush_cb(display_, flush);
  lv_display_add_event_cb(display_, on_invalidate, LV_EVENT_INVALIDATE_AREA, this);
  lv_obj_set_scrollable(lv_screen_active(), false);  // scroll bars would be drawn
  lv_obj_set_style_bg_color(lv_screen_active(), lv_color_hex(0x204060), 0);
}

Screen::~Screen() {
  fail_allocations_from(0);
  lv_deinit();
}

void Screen::flush(lv_display_t* display, const lv_area_t* area, std::uint8_t* bytes) {
  auto& screen = *static_cast<Screen*>(lv_display_get_user_data(display));
  ++screen.flushes;
  if (screen.in_flush != nullptr) screen.in_flush(screen.flush_data);
  const bool is_partial = screen.setting_.mode == LV_DISPLAY_RENDER_MODE_PARTIAL;
  const std::int32_t buffer_width = is_partial ? lv_area_get_width(area) : kWidth;
  const std::size_t stride =
      lv_draw_buf_width_to_stride(static_cast<std::uint32_t>(buffer_width), screen.setting_.format);
  const std::size_t pixel = screen.pixel_bytes();
  for (std::int32_t y = area->y1; y <= area->y2; ++y) {
    for (std::int32_t x = area->x1; x <= area->x2; ++x) {
      const auto row = static_cast<std::size_t>(is_partial ? y - area->y1 : y);
      const auto column = static_cast<std::size_t>(is_partial ? x - area->x1 : x);
      for (std::size_t i = 0; i < pixel; ++i) {
        screen.pixels[static_cast<std::size_t>(y * kWidth + x) * pixel + i] =
            bytes[row * stride + column * pixel + i];
      }
    }
  }
  lv_display_flush_ready(display);
}

void Screen::on_invalidate(lv_event_t* e) {
  const lv_area_t& area = *lv_event_get_invalidated_area(e);
  // By the same event LVGL asks how many rows may be drawn at a time, with an area of one column at the
  // origin.
  const bool is_question = area.x1 == 0 && area.y1 == 0 && area.x2 == 0;
  if (!is_question) static_cast<Screen*>(lv_event_get_user_data(e))->invalidated.push_back(area);
}

std::vector<std::uint8_t> Screen::redrawn() {
  lv_obj_invalidate(lv_screen_active());
  refresh();
  return pixels;
}

std::vector<std::uint8_t> Screen::pixel(std::int32_t x, std::int32_t y) const {
  const auto at = pixels.begin() + (y * kWidth + x) * static_cast<std::int32_t>(pixel_bytes());
  return {at, at + static_cast<std::int32_t>(pixel_bytes())};
}

const arcspan_model& outlined_ball() {
  static c::ModelPart part = ball.parts[0];
  part.make_neighbours = [](const MeshView& mesh, MeshNeighbours& neighbours) {
    static const TestNeighbours made(mesh, true);
    neighbours = made.view;
    return Status::kOk;
  };
  static const arcspan_model model{&part, 1};
  return model;
}

BallScene::BallScene(const arcspan_model& model) {
  const arcspan_scene_limits limits{1, 0};
  memory.resize(arcspan_scene_bytes(&limits));
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &limits, &scene) == ARCSPAN_OK);
  REQUIRE(arcspan_add_model(scene, &model, &object) == ARCSPAN_OK);
}

lv_obj_t* make_view(const BallScene& balls) {
  lv_obj_t* const view = lv_arcspan_view_create(lv_screen_active());
  REQUIRE(view != nullptr);
  lv_obj_set_pos(view, 20, 10);
  lv_obj_set_size(view, 100, 80);
  lv_arcspan_view_set_scene(view, balls.scene);
  lv_arcspan_view_set_turned(view, balls.object);
  return view;
}

}  // namespace arcspan::test
