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

/// A drag of the mouse by (dx, dy) pixels, from row 50 of column `x`.
void drag(std::int32_t x, std::int32_t dx, std::int32_t dy) {
  lv_test_mouse_move_to(x, 50);
  lv_test_mouse_press();
  lv_test_wait(50);
  lv_test_mouse_move_by(dx, dy);
  lv_test_wait(50);
  lv_test_mouse_release();
  lv_test_wait(50);
}

TEST_CASE("a drag turns the object that was named, and says so") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  int changes = 0;
  lv_obj_add_event_cb(view, count_event, LV_EVENT_VALUE_CHANGED, &changes);
  lv_test_wait(50);
  const arcspan_quaternion before = lv_arcspan_view_get_rotation(view);
  drag(60, 12, 0);
  const arcspan_quaternion after = lv_arcspan_view_get_rotation(view);
  CHECK(changes == 1);
  CHECK(before.y == 0);
  CHECK(after.y > 0);
  CHECK(after.x == 0);
  lv_arcspan_view_set_turned(view, LV_ARCSPAN_NO_OBJECT);
  drag(60, 0, 12);
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
  CHECK(std::abs(lv_arcspan_view_get_rotation(view).x) < 256);
  lv_group_set_editing(lv_group_get_default(), true);
  lv_test_encoder_turn(2);
  CHECK(lv_arcspan_view_get_rotation(view).y > once);
  std::int32_t steps = 1;
  lv_arcspan_view_set_rotation(view, ARCSPAN_NO_ROTATION);
  lv_obj_send_event(view, LV_EVENT_ROTARY, &steps);
  const std::int32_t by_wheel = lv_arcspan_view_get_rotation(view).y;
  CHECK(by_wheel > 0);
  steps = -2;
  lv_obj_send_event(view, LV_EVENT_ROTARY, &steps);
  CHECK(std::abs(lv_arcspan_view_get_rotation(view).y + by_wheel) < by_wheel / 8);
}

TEST_CASE("a view that is turned joins the default group, unless it is in one") {
  TestDisplay display;
  lv_group_t* const group = lv_group_create();
  lv_obj_t* const view = lv_arcspan_view_create(lv_screen_active());
  lv_obj_t* const other = lv_arcspan_view_create(lv_screen_active());
  lv_group_add_obj(group, view);
  lv_arcspan_view_set_turned(view, 0);
  lv_arcspan_view_set_turned(other, 0);
  CHECK(lv_obj_get_group(view) == group);
  CHECK(lv_obj_get_group(other) == lv_group_get_default());
}

/// A drag from the middle of the view. Returns the rotation after it.
arcspan_quaternion rotation_after_drag(lv_obj_t* view) {
  lv_test_wait(50);
  drag(70, 12, 0);
  return lv_arcspan_view_get_rotation(view);
}

TEST_CASE("a drag over a view that is turned and scaled moves the object as the finger moves") {
  TestDisplay display;
  lv_obj_t* const box = lv_obj_create(lv_screen_active());
  lv_obj_remove_style_all(box);
  lv_obj_set_size(box, 160, 120);
  lv_obj_t* const view = make_view(display.balls);
  lv_obj_set_parent(view, box);
  const std::int32_t straight = rotation_after_drag(view).y;
  lv_arcspan_view_set_rotation(view, ARCSPAN_NO_ROTATION);
  lv_obj_set_style_transform_pivot_x(box, 70, 0);
  lv_obj_set_style_transform_pivot_y(box, 50, 0);
  SECTION("by its own style") {
    lv_obj_set_style_transform_pivot_x(view, 50, 0);
    lv_obj_set_style_transform_pivot_y(view, 40, 0);
    lv_obj_set_style_transform_rotation(view, 900, 0);
  }
  SECTION("by that of its parent") { lv_obj_set_style_transform_rotation(box, 900, 0); }
  SECTION("to twice its size") {
    lv_obj_set_style_transform_scale(box, 512, 0);
    CHECK(std::abs(rotation_after_drag(view).y - straight / 2) < straight / 8);
    return;
  }
  // The picture's upper side is now at the right: the finger moves upwards in it.
  const arcspan_quaternion turned = rotation_after_drag(view);
  CHECK(std::abs(turned.x + straight) < straight / 8);
  CHECK(std::abs(turned.y) < straight / 8);
}

#if LV_USE_GESTURE_RECOGNITION
/// A touch panel with two fingers, `distance` pixels apart, or none if that is 0.
struct Fingers {
  std::int32_t distance = 0;
  bool first_is_lifted = false;
  lv_indev_t* device = lv_indev_create();

  Fingers() {
    lv_indev_set_type(device, LV_INDEV_TYPE_POINTER);
    lv_indev_set_user_data(device, this);
    lv_indev_set_read_cb(device, [](lv_indev_t* indev, lv_indev_data_t* data) {
      const auto& fingers = *static_cast<const Fingers*>(lv_indev_get_user_data(indev));
      const std::int32_t half = fingers.distance / 2;
      const lv_indev_state_t state = half != 0 ? LV_INDEV_STATE_PRESSED : LV_INDEV_STATE_RELEASED;
      lv_indev_touch_data_t touches[2] = {};
      for (int i = 0; i < 2; ++i) {
        touches[i].point = {i == 0 ? 70 - half : 70 + half, 50};
        touches[i].state = state;
        touches[i].id = static_cast<std::uint8_t>(i);
      }
      if (fingers.first_is_lifted) touches[0].state = LV_INDEV_STATE_RELEASED;
      data->point = touches[fingers.first_is_lifted ? 1 : 0].point;
      lv_indev_gesture_recognizers_update(indev, touches, 2);
      lv_indev_gesture_recognizers_set_data(indev, data);
    });
  }
  /// Holds the fingers so for some readings.
  void hold(std::int32_t pixels) {
    distance = pixels;
    lv_test_wait(200);
  }
};

TEST_CASE("a pinch scales the object from its scale on, and does not turn it") {
  TestDisplay display;
  lv_obj_t* const view = make_view(display.balls);
  Fingers fingers;
  lv_test_wait(50);
  const arcspan_quaternion before = lv_arcspan_view_get_rotation(view);
  // Slowly at first, where LVGL does not know yet that it is a pinch.
  for (std::int32_t distance = 20; distance <= 60; distance += distance < 28 ? 2 : 8) fingers.hold(distance);
  CHECK(lv_arcspan_view_get_scale(view) == ARCSPAN_LENGTH(3));
  CHECK(lv_arcspan_view_get_rotation(view).y == before.y);
  SECTION("the end of the first pinch is sent to the view") { fingers.hold(0); }
  SECTION("one finger is lifted before the other") {
    fingers.first_is_lifted = true;
    fingers.hold(60);
    CHECK(lv_arcspan_view_get_rotation(view).y == before.y);
    fingers.hold(0);
    fingers.first_is_lifted = false;
  }
  SECTION("the end of the first pinch is sent to no widget") {
    lv_indev_wait_release(fingers.device);
    fingers.hold(0);
  }
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  int changes = 0;
  lv_obj_add_event_cb(view, count_event, LV_EVENT_VALUE_CHANGED, &changes);
  fingers.hold(20);
  fingers.hold(40);
  CHECK(lv_arcspan_view_get_scale(view) == ARCSPAN_LENGTH(1));
  CHECK(changes > 0);
  fingers.hold(0);
  for (const arcspan_length most : {INT32_MAX, ARCSPAN_LENGTH(1)}) {  // a scale out of range, no object
    lv_arcspan_view_set_scale(view, most);
    fingers.hold(20);
    fingers.hold(40);
    CHECK(lv_arcspan_view_get_scale(view) == most);
    fingers.hold(0);
    drag(60, 12, 0);
    CHECK((lv_arcspan_view_get_rotation(view).y != before.y));
    lv_arcspan_view_set_scale(view, 80);
    fingers.hold(40);
    fingers.hold(20);
    CHECK(lv_arcspan_view_get_scale(view) >= 64);
    fingers.hold(0);
    lv_arcspan_view_set_turned(view, LV_ARCSPAN_NO_OBJECT);
  }
}
#endif

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
