// SPDX-License-Identifier: MIT
// lv_arcspan_view by LVGL's test module: mouse, keys, encoder, and pictures compared with stored ones.
#include <tests/lvgl/screen.hpp>

#if LV_USE_TEST

extern "C" arcspan_status show_ball(void);

namespace {

using namespace arcspan::test;

/// LVGL with its test display of 160 x 120 pixels and its input devices.
struct TestDisplay {
  BallScene balls;

  TestDisplay() {
    lv_init();
    lv_test_display_create(160, 120);
    lv_test_indev_create_all();
    lv_group_set_default(lv_group_create());
    lv_indev_set_group(lv_test_indev_get_indev(LV_INDEV_TYPE_KEYPAD), lv_group_get_default());
    lv_indev_set_group(lv_test_indev_get_indev(LV_INDEV_TYPE_ENCODER), lv_group_get_default());
  }
  ~TestDisplay() {
    lv_test_indev_delete_all();
    lv_deinit();
  }
  TestDisplay(const TestDisplay&) = delete;
  TestDisplay& operator=(const TestDisplay&) = delete;
};

bool is_picture(const char* name) {
  return lv_test_screenshot_compare(name) == LV_TEST_SCREENSHOT_RESULT_PASSED;
}

void count_event(lv_event_t* e) { ++*static_cast<int*>(lv_event_get_user_data(e)); }

TEST_CASE("a drag turns the object that was named, and says so") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  int changes = 0;
  lv_obj_add_event_cb(view, count_event, LV_EVENT_VALUE_CHANGED, &changes);
  lv_test_wait(50);
  const arcspan_quaternion before = lv_arcspan_view_get_rotation(view);
  lv_test_mouse_move_to(60, 50);
  lv_test_mouse_press();
  lv_test_wait(50);
  lv_test_mouse_move_by(12, 0);
  lv_test_wait(50);
  lv_test_mouse_release();
  lv_test_wait(50);
  const arcspan_quaternion after = lv_arcspan_view_get_rotation(view);
  CHECK(changes == 1);
  CHECK(before.y == 0);
  CHECK(after.y > 0);
  CHECK(after.x == 0);
  lv_arcspan_view_set_turned(view, LV_ARCSPAN_NO_OBJECT);
  lv_test_mouse_move_to(60, 50);
  lv_test_mouse_press();
  lv_test_wait(50);
  lv_test_mouse_move_by(0, 12);
  lv_test_wait(50);
  lv_test_mouse_release();
  lv_test_wait(50);
  CHECK(lv_arcspan_view_get_rotation(view).x == 0);
}

TEST_CASE("arrow keys and an encoder turn the object") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  lv_test_wait(50);
  lv_group_focus_obj(view);
  lv_test_key_hit(LV_KEY_RIGHT);
  const std::int32_t once = lv_arcspan_view_get_rotation(view).y;
  CHECK(once > 0);
  lv_test_key_hit(LV_KEY_LEFT);
  CHECK(std::abs(lv_arcspan_view_get_rotation(view).y) < 256);
  lv_test_key_hit(LV_KEY_DOWN);
  CHECK(lv_arcspan_view_get_rotation(view).x > 0);
  lv_test_key_hit(LV_KEY_UP);
  lv_group_set_editing(lv_group_get_default(), true);
  lv_test_encoder_turn(2);
  CHECK(lv_arcspan_view_get_rotation(view).y > once);
}

TEST_CASE("styles: background, border, round corners, opacity, layers and transforms") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  lv_obj_set_size(view, 120, 100);
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(1.3));
  lv_obj_set_style_bg_color(view, lv_color_hex(0x803010), 0);
  lv_obj_set_style_bg_opa(view, LV_OPA_COVER, 0);
  lv_obj_set_style_border_width(view, 3, 0);
  lv_obj_set_style_pad_all(view, 0, 0);
  CHECK(is_picture("background.png"));
  lv_obj_set_style_radius(view, 40, 0);
  lv_obj_set_style_clip_corner(view, true, 0);
  CHECK(is_picture("corners.png"));
  lv_obj_set_style_opa(view, LV_OPA_50, 0);
  CHECK(is_picture("opacity.png"));
  lv_obj_set_style_opa(view, LV_OPA_COVER, 0);
  lv_obj_set_style_opa_layered(view, LV_OPA_50, 0);
  CHECK(is_picture("layered.png"));
  lv_obj_set_style_opa_layered(view, LV_OPA_COVER, 0);
  lv_obj_set_style_transform_rotation(view, 300, 0);
  lv_obj_set_style_transform_scale(view, 180, 0);
  CHECK(is_picture("transform.png"));  // of two threads: LVGL rounds the edges of its tiles
  CHECK(lv_arcspan_view_get_dropped(view) == 0);
}

TEST_CASE("the example shows a ball, a label and a slider") {
  TestDisplay display;
  REQUIRE(show_ball() == ARCSPAN_OK);
  CHECK(is_picture("example.png"));
}

TEST_CASE("a snapshot of a view that was never shown has its picture") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  lv_obj_update_layout(view);
  lv_draw_buf_t* const picture = lv_snapshot_take(view, LV_COLOR_FORMAT_ARGB8888);
  REQUIRE(picture != nullptr);
  lv_obj_set_style_bg_opa(view, LV_OPA_TRANSP, 0);
  const auto* const middle = static_cast<const std::uint8_t*>(
      lv_draw_buf_goto_xy(picture, picture->header.w / 2u, picture->header.h / 2u));
  CHECK(middle[3] == 255);
  CHECK(middle[0] > 60);
  lv_draw_buf_destroy(picture);
}

}  // namespace

#endif
