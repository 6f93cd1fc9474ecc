// SPDX-License-Identifier: MIT
// lv_arcspan_view in the real LVGL.
#include <tests/lvgl/frames.h>
#include <tests/lvgl/screen.hpp>

#include <algorithm>
#include <memory>

namespace {

void put_label_above(lv_obj_t* view) {
  lv_obj_t* const label = lv_label_create(view);
  lv_label_set_text(label, "above");
  lv_obj_center(label);
}

using namespace arcspan::test;

constexpr lv_color_format_t kFormats[] = {LV_COLOR_FORMAT_RGB565,   LV_COLOR_FORMAT_RGB565_SWAPPED,
                                          LV_COLOR_FORMAT_RGB888,   LV_COLOR_FORMAT_XRGB8888,
                                          LV_COLOR_FORMAT_ARGB8888, LV_COLOR_FORMAT_L8};

arcspan_format format_of(lv_color_format_t format) {
  switch (format) {
    case LV_COLOR_FORMAT_RGB565_SWAPPED:
      return ARCSPAN_RGB565_SWAPPED;
    case LV_COLOR_FORMAT_RGB888:
      return ARCSPAN_BGR888;
    case LV_COLOR_FORMAT_XRGB8888:
      return ARCSPAN_XRGB8888;
    case LV_COLOR_FORMAT_ARGB8888:
      return ARCSPAN_ARGB8888;
    case LV_COLOR_FORMAT_L8:
      return ARCSPAN_GRAY8;
    default:
      return ARCSPAN_RGB565;
  }
}

bool is_in(const lv_point_t& point, const lv_area_t& area) {
  return point.x >= area.x1 && point.x <= area.x2 && point.y >= area.y1 && point.y <= area.y2;
}

constexpr arcspan_outline_limits kOutlines{300, 1000, 4000, 0};

/// How the outlines of a view are drawn.
enum Outlines { kPlain, kSmooth, kInked, kInkedCreases };

void set_outlines(lv_obj_t* view, Outlines outlines) {
  const arcspan_ink ink{{200, 40, 90}, 3, outlines == kInkedCreases};
  REQUIRE(lv_arcspan_view_set_outlines(view, outlines == kPlain ? nullptr : &kOutlines,
                                       outlines < kInked ? nullptr : &ink) == ARCSPAN_OK);
}

std::vector<std::uint8_t> shown(const DisplaySetting& setting, Outlines outlines = kPlain) {
  Screen screen(setting);
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  set_outlines(view, outlines);
  put_label_above(view);
  screen.refresh();
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
  CHECK(lv_arcspan_view_get_dropped(view) == 0);
  return screen.pixels;
}

TEST_CASE("the frames that boards draw have the same hashes here") {
  REQUIRE(lvgl_frames_start() == ARCSPAN_OK);
  for (int i = 0; i < LVGL_FRAMES; ++i) {
    CAPTURE(i);
    CHECK(lvgl_frames_next() == lvgl_frame_hashes[i]);
  }
  lv_deinit();
}

TEST_CASE("partial, direct and full rendering show the same pixels, in every format, in padded rows") {
  for (const lv_color_format_t format : kFormats) {
    CAPTURE(format);
    const auto direct = shown({format, LV_DISPLAY_RENDER_MODE_DIRECT});
    CHECK((shown({format, LV_DISPLAY_RENDER_MODE_FULL}) == direct));
    CHECK((shown({format, LV_DISPLAY_RENDER_MODE_PARTIAL, 20}) == direct));
    CHECK((shown({format, LV_DISPLAY_RENDER_MODE_PARTIAL, 7}) == direct));
  }
}

TEST_CASE("smooth and inked outlines are the same, whatever is drawn at a time") {
  for (const lv_color_format_t format :
       {LV_COLOR_FORMAT_RGB565, LV_COLOR_FORMAT_XRGB8888, LV_COLOR_FORMAT_ARGB8888}) {
    CAPTURE(format);
    auto before = shown({format, LV_DISPLAY_RENDER_MODE_DIRECT});
    for (const Outlines outlines : {kSmooth, kInked, kInkedCreases}) {
      CAPTURE(outlines);
      const auto direct = shown({format, LV_DISPLAY_RENDER_MODE_DIRECT}, outlines);
      CHECK((direct != before));
      CHECK((shown({format, LV_DISPLAY_RENDER_MODE_PARTIAL, 20}, outlines) == direct));
      CHECK((shown({format, LV_DISPLAY_RENDER_MODE_PARTIAL, 7}, outlines) == direct));
      before = direct;
    }
  }
}

/// The camera of a new view.
constexpr lv_arcspan_camera_t kFront{
    ARCSPAN_DEGREES(45), 0, ARCSPAN_LENGTH(1), ARCSPAN_LENGTH(16), {0, 0, ARCSPAN_LENGTH(3)}, {}, {}};

/// The ball drawn by arcspan_draw() alone, 100 x 80 pixels on black.
std::vector<std::uint8_t> drawn_bare(const BallScene& balls, lv_color_format_t format, Outlines outlines,
                                     const lv_arcspan_camera_t& camera) {
  const arcspan_view_limits limits = arcspan_limits_of(balls.scene, 0);
  std::vector<unsigned char> memory(arcspan_view_bytes(&limits));
  std::vector<unsigned char> outline_memory(arcspan_outline_bytes(&kOutlines));
  arcspan_view* bare = nullptr;
  REQUIRE(arcspan_view_make(memory.data(), memory.size(), &limits, balls.scene, &bare) == ARCSPAN_OK);
  const arcspan_lens lens{100, 80, camera.angle, camera.extent, camera.nearest, camera.farthest};
  REQUIRE(arcspan_set_camera(bare, &lens, camera.eye, camera.target, camera.up) == ARCSPAN_OK);
  void* const given = outlines == kPlain ? nullptr : outline_memory.data();
  REQUIRE(arcspan_smooth_outlines(bare, given, outline_memory.size(), &kOutlines) == ARCSPAN_OK);
  REQUIRE(arcspan_prepare(bare) == ARCSPAN_OK);
  const std::size_t pixel = lv_color_format_get_size(format);
  std::vector<std::uint8_t> pixels(100 * 80 * pixel);
  std::vector<std::uint16_t> depths(100 * 80);
  const arcspan_rgb black{0, 0, 0};
  const arcspan_target target{pixels.data(),     pixels.size(),   static_cast<std::int32_t>(100 * pixel),
                              format_of(format), {0, 0, 100, 80}, depths.data(),
                              depths.size(),     &black};
  REQUIRE(arcspan_draw(bare, &target) == ARCSPAN_OK);
  return pixels;
}

void check_picture(lv_color_format_t format, Outlines outlines, const lv_arcspan_camera_t& camera = kFront) {
  CAPTURE(format, outlines);
  Screen screen({format, LV_DISPLAY_RENDER_MODE_PARTIAL, 16});
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  set_outlines(view, outlines);
  lv_obj_set_style_bg_opa(view, LV_OPA_COVER, 0);
  lv_obj_set_style_bg_color(view, lv_color_black(), 0);
  lv_obj_set_style_border_width(view, 0, 0);
  lv_obj_set_style_radius(view, 0, 0);
  lv_obj_set_style_pad_all(view, 0, 0);
  screen.refresh();
  if (&camera != &kFront) lv_arcspan_view_set_camera(view, &camera);
  screen.refresh();
  const std::vector<std::uint8_t> pixels = drawn_bare(balls, format, outlines, camera);
  const std::size_t pixel = screen.pixel_bytes();
  const int tolerance = outlines == kPlain ? 0 : 2;  // LVGL rounds otherwise
  for (std::int32_t y = 0; y < 80; ++y) {
    for (std::int32_t x = 0; x < 100; ++x) {
      const std::vector<std::uint8_t> found = screen.pixel(20 + x, 10 + y);
      const auto at = static_cast<std::size_t>(y * 100 + x) * pixel;
      for (std::size_t i = 0; i < pixel; ++i) {
        if (format == LV_COLOR_FORMAT_XRGB8888 && i == 3) continue;  // of no meaning
        REQUIRE(std::abs(found[i] - pixels[at + i]) <= tolerance);
      }
    }
  }
}

TEST_CASE("the picture is the one that arcspan_draw() draws over the background") {
  for (const lv_color_format_t format : kFormats) check_picture(format, kPlain);
  for (const lv_color_format_t format :
       {LV_COLOR_FORMAT_RGB888, LV_COLOR_FORMAT_XRGB8888, LV_COLOR_FORMAT_ARGB8888, LV_COLOR_FORMAT_L8})
    check_picture(format, kSmooth);
  check_picture(LV_COLOR_FORMAT_RGB565, kPlain,
                {0, ARCSPAN_LENGTH(1.5), 65536, 250000, {70000, 20000, 190000}, {9000, -9000, 0}, {1, 1, 0}});
}

TEST_CASE("smooth outlines need no other format than that of layers") {
  const auto layered = shown({LV_COLOR_FORMAT_ARGB8888_PREMULTIPLIED}, kSmooth);  // is not compiled
  const auto expected = shown({LV_COLOR_FORMAT_ARGB8888}, kSmooth);
  int most = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) most = std::max(most, std::abs(layered[i] - expected[i]));
  CHECK(most <= 4);  // LVGL rounds otherwise
  Screen screen({LV_COLOR_FORMAT_ARGB8888_PREMULTIPLIED});
  BallScene balls;
  lv_obj_t* const plain = make_view(balls);
  screen.refresh();
  CHECK(lv_arcspan_view_get_status(plain) == ARCSPAN_UNSUPPORTED);
  CHECK(lv_arcspan_view_get_dropped(plain) > 0);
}

TEST_CASE("a repaint of some columns leaves smooth outlines as they are") {
  Screen screen;
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  set_outlines(view, GENERATE(kSmooth, kInkedCreases));
  screen.refresh();
  const auto pixels = screen.pixels;
  for (std::int32_t x = 40; x < 100; ++x) {
    const lv_area_t columns{x, 0, x + 5, Screen::kHeight - 1};
    lv_obj_invalidate_area(lv_screen_active(), &columns);
    screen.refresh();
    REQUIRE((screen.pixels == pixels));
  }
}

TEST_CASE("LVGL draws its own images beside a view") {
  static const std::uint16_t red[4] = {0xF800, 0xF800, 0xF800, 0xF800};
  lv_image_dsc_t image{};
  image.header.magic = LV_IMAGE_HEADER_MAGIC;
  image.header.cf = LV_COLOR_FORMAT_RGB565;
  image.header.w = image.header.h = 2;
  image.header.stride = 4;
  image.data = reinterpret_cast<const std::uint8_t*>(red);
  image.data_size = sizeof red;
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  lv_image_set_src(lv_image_create(lv_screen_active()), &image);
  screen.refresh();
  CHECK((screen.pixel(1, 1) == std::vector<std::uint8_t>{0x00, 0xF8}));
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
}

TEST_CASE("a layer whose outlines lack memory for depths is left out, and the next frame is right") {
  const auto expected = shown({}, kSmooth);
  Screen screen({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_DIRECT});
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  put_label_above(view);
  set_outlines(view, kSmooth);
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.2));
  screen.refresh();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(1));
  fail_allocations_from(2500, 5000);  // more depths, but no layer
  screen.refresh();
  CHECK(lv_arcspan_view_get_dropped(view) > 0);
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_BUFFER_TOO_SMALL);
  fail_allocations_from(0);
  screen.refresh();
  CHECK((screen.pixels == expected));
}

TEST_CASE("outlines that cannot be smoothed leave the picture as it is, with a status") {
  const auto plain = shown({});
  SECTION("ink out of range is refused") {
    Screen screen;
    BallScene balls(outlined_ball());
    lv_obj_t* const view = make_view(balls);
    for (const std::uint8_t width : {std::uint8_t{0}, std::uint8_t{5}}) {
      const arcspan_ink ink{{0, 0, 0}, width, 0};
      CHECK(lv_arcspan_view_set_outlines(view, &kOutlines, &ink) == ARCSPAN_INVALID_ARGUMENT);
    }
  }
  SECTION("without neighbours") {
    Screen screen;
    BallScene balls;
    lv_obj_t* const view = make_view(balls);
    set_outlines(view, kSmooth);
    put_label_above(view);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_UNSUPPORTED);
    CHECK(lv_arcspan_view_get_dropped(view) == 0);
    CHECK((screen.pixels == plain));
  }
  SECTION("with too little memory") {
    const auto smooth = shown({}, kSmooth);
    Screen screen;
    BallScene balls(outlined_ball());
    lv_obj_t* const view = make_view(balls);
    put_label_above(view);
    const arcspan_outline_limits few{300, 1, 1000, 0};
    REQUIRE(lv_arcspan_view_set_outlines(view, &few, nullptr) == ARCSPAN_OK);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_BUFFER_TOO_SMALL);
    CHECK(lv_arcspan_view_get_dropped(view) == 0);
    CHECK((screen.pixels == plain));
    screen.invalidated.clear();
    screen.refresh();
    CHECK(screen.invalidated.empty());  // it is not tried again

    set_outlines(view, kSmooth);  // takes 76 KB
    fail_allocations_from(20000);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_BUFFER_TOO_SMALL);
    CHECK(lv_arcspan_view_get_dropped(view) == 1);
    fail_allocations_from(0);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
    CHECK((screen.pixels == smooth));
  }
}

TEST_CASE("a colour that styles lay over a view, or over what holds it, lies over the scene, too") {
  Screen screen;
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  set_outlines(view, GENERATE(kPlain, kSmooth));
  lv_obj_t* const coloured = GENERATE(false, true) ? lv_screen_active() : view;
  screen.refresh();
  const auto plain = screen.pixels;
  const auto middle = screen.pixel(70, 50);
  lv_obj_set_style_recolor(coloured, lv_color_hex(0xFF0000), 0);
  lv_obj_set_style_recolor_opa(coloured, LV_OPA_50, 0);
  screen.refresh();
  CHECK((screen.pixel(70, 50) != middle));
  lv_obj_set_style_recolor_opa(coloured, LV_OPA_COVER, 0);
  screen.refresh();
  CHECK((screen.pixel(70, 50) == std::vector<std::uint8_t>{0x00, 0xF8}));  // red in rgb565
  lv_obj_set_style_recolor_opa(coloured, LV_OPA_TRANSP, 0);
  screen.refresh();
  CHECK((screen.pixels == plain));
  CHECK(lv_arcspan_view_get_dropped(view) == 0);
}

TEST_CASE("round corners are those of the widget where its border lacks a side") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(1.9));
  lv_obj_set_style_pad_all(view, 0, 0);
  lv_obj_set_style_radius(view, 30, 0);
  lv_obj_set_style_clip_corner(view, true, 0);
  lv_obj_set_style_border_width(view, 0, 0);
  screen.refresh();
  const auto without = screen.pixels;
  lv_obj_set_style_border_width(view, 12, 0);
  lv_obj_set_style_border_side(view, LV_BORDER_SIDE_NONE, 0);
  screen.refresh();
  CHECK((screen.pixels == without));
  for (std::int32_t y = 0; y < 23; ++y) CHECK((screen.pixel(20, 10 + y) == screen.pixel(0, 0)));
  for (std::int32_t x = 20; x < 120; x += 30) {  // the left and the right corners alone
    const lv_area_t columns{x, 0, x + 29, Screen::kHeight - 1};
    lv_obj_invalidate_area(lv_screen_active(), &columns);
    screen.refresh();
    CHECK((screen.pixels == without));
  }
  lv_obj_set_style_radius(view, 40, 0);
  const auto half = screen.redrawn();
  lv_obj_set_style_radius(view, LV_RADIUS_CIRCLE, 0);
  CHECK((screen.redrawn() == half));
  lv_obj_set_style_clip_corner(view, false, 0);
  CHECK((screen.redrawn() != half));
}

TEST_CASE("400 random repaints show what one redraw of all shows") {
  std::mt19937 random(7);
  const auto number = [&](std::int32_t least, std::int32_t most) {
    return std::uniform_int_distribution<std::int32_t>(least, most)(random);
  };
  Screen screen({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL, 12});
  BallScene balls(outlined_ball());
  lv_obj_t* const view = make_view(balls);
  lv_obj_set_style_radius(view, 25, 0);
  lv_obj_set_style_clip_corner(view, true, 0);
  arcspan_quaternion rotation{1 << 30, 0, 0, 0};
  for (int i = 0; i < 400; ++i) {
    switch (number(0, 5)) {
      case 5:
        set_outlines(view, static_cast<Outlines>(number(kPlain, kInkedCreases)));
        break;
      case 0:
        rotation = arcspan_multiply(
            {1 << 30, number(-100000000, 100000000), number(-100000000, 100000000), 0}, rotation);
        lv_arcspan_view_set_rotation(view, rotation);
        break;
      case 1:
        lv_obj_set_pos(view, number(-60, 120), number(-50, 90));
        break;
      case 2:
        lv_arcspan_view_set_scale(view, number(10000, 100000));
        break;
      case 3:
        lv_obj_set_style_opa(view, number(0, 1) == 0 ? LV_OPA_COVER : LV_OPA_50, 0);
        break;
      default: {
        const std::int32_t x = number(0, Screen::kWidth - 1);
        const std::int32_t y = number(0, Screen::kHeight - 1);
        const lv_area_t area{x, y, number(x, Screen::kWidth - 1), number(y, Screen::kHeight - 1)};
        lv_obj_invalidate_area(lv_screen_active(), &area);
      }
    }
    screen.refresh();
    if (i % 10 != 9) continue;
    const auto so_far = screen.pixels;
    REQUIRE((screen.redrawn() == so_far));
  }
  CHECK(lv_arcspan_view_get_dropped(view) == 0);
}

TEST_CASE("a change invalidates the rectangles of the old and of the new frame, and nothing else") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  const auto before = screen.pixels;
  screen.invalidated.clear();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  CHECK(screen.invalidated.empty());  // not before the refresh
  screen.refresh();
  REQUIRE(screen.invalidated.size() == 2);
  const auto& old_area = screen.invalidated[0];
  const auto& new_area = screen.invalidated[1];
  CHECK((is_in({new_area.x1, new_area.y1}, old_area) && is_in({new_area.x2, new_area.y2}, old_area)));
  CHECK(lv_area_get_size(&new_area) < lv_area_get_size(&old_area) / 2);
  for (std::int32_t y = 0; y < Screen::kHeight; ++y) {  // what has changed lies within, up to its sides
    for (std::int32_t x = 0; x < Screen::kWidth; ++x) {
      const auto at = static_cast<std::size_t>(2 * (y * Screen::kWidth + x));
      const bool changed = before[at] != screen.pixels[at] || before[at + 1] != screen.pixels[at + 1];
      if (changed) REQUIRE(is_in({x, y}, old_area));
    }
  }
  screen.invalidated.clear();
  screen.refresh();
  CHECK(screen.invalidated.empty());
}

TEST_CASE("the frame of a view one pixel wide is wiped before the next") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  lv_obj_remove_style_all(view);
  lv_obj_set_pos(view, 20, 10);
  lv_obj_set_size(view, 1, 80);
  screen.refresh();
  const auto before = screen.pixels;
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.3));
  screen.refresh();
  const auto pixels = screen.pixels;
  CHECK((pixels != before));
  CHECK((screen.redrawn() == pixels));
}

TEST_CASE("nothing is done while a view is hidden, and its next frame is right") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  screen.refresh();
  const auto small = screen.pixels;
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(1));
  lv_obj_set_hidden(view, true);
  screen.refresh();
  const std::uint32_t flushes = screen.flushes;
  screen.invalidated.clear();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  screen.refresh();
  CHECK(screen.invalidated.empty());
  CHECK(screen.flushes == flushes);
  lv_obj_set_hidden(view, false);
  screen.refresh();
  CHECK((screen.pixels == small));
}

TEST_CASE("a rotation that is set while a frame is drawn waits for the next one") {
  Screen screen({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL, 8});
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  const auto first = screen.pixels;
  screen.flush_data = view;
  screen.in_flush = [](void* data) {
    lv_arcspan_view_set_rotation(static_cast<lv_obj_t*>(data), {1 << 30, 1 << 29, 1 << 28, 0});
  };
  CHECK((screen.redrawn() == first));
  screen.in_flush = nullptr;
  screen.refresh();
  CHECK((screen.pixels != first));
  const auto turned = screen.pixels;
  CHECK((screen.redrawn() == turned));
}

TEST_CASE("memory that cannot be allocated drops rectangles, and the next frame is right") {
  const auto expected = shown({});
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  put_label_above(view);
  SECTION("of the view") {
    fail_allocations_from(2000);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_BUFFER_TOO_SMALL);
    CHECK(lv_arcspan_view_get_dropped(view) > 0);
    CHECK((screen.pixels != expected));
  }
  SECTION("of a layer") {
    lv_obj_set_style_opa(view, LV_OPA_50, 0);
    screen.refresh();
    fail_allocations_from(1500);
    (void)screen.redrawn();
    CHECK(lv_arcspan_view_get_dropped(view) > 0);
    lv_obj_set_style_opa(view, LV_OPA_COVER, 0);
  }
  fail_allocations_from(0);
  screen.refresh();  // without a further change
  CHECK((screen.pixels == expected));
  CHECK((screen.redrawn() == expected));
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
}

TEST_CASE("without memory for the rows of triangles a view keeps its vertices") {
  Screen screen;
  const arcspan_scene_limits two_balls{2, 0};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&two_balls));
  BallScene balls;
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &two_balls, &balls.scene) == ARCSPAN_OK);
  for (int i = 0; i < 2; ++i) REQUIRE(arcspan_add_model(balls.scene, &ball, &balls.object) == ARCSPAN_OK);
  lv_obj_t* const view = make_view(balls);
  arcspan_view_limits limits = arcspan_limits_of(balls.scene, 1);
  const std::size_t with_rows = arcspan_view_bytes(&limits);
  fail_allocations_from(with_rows, with_rows + 1);
  screen.refresh();
  limits.triangles = 0;
  const std::size_t without_rows = arcspan_view_bytes(&limits);
  CHECK(was_allocated(without_rows));
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
  const auto drawn = screen.pixels;
  lv_obj_t* const other = make_view(balls);  // without memory for all vertices it keeps none
  fail_allocations_from(without_rows, with_rows + 1);
  screen.refresh();
  limits = arcspan_limits_of(balls.scene, 0);
  CHECK(was_allocated(arcspan_view_bytes(&limits)));
  CHECK(lv_arcspan_view_get_status(other) == ARCSPAN_OK);
  lv_obj_delete(other);
  fail_allocations_from(0);
  CHECK((screen.redrawn() == drawn));
}

TEST_CASE("objects that are added to a scene are shown; one that is not there cannot be turned") {
  Screen screen;
  const arcspan_scene_limits two_balls{2, 0};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&two_balls));
  BallScene balls;
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &two_balls, &balls.scene) == ARCSPAN_OK);
  REQUIRE(arcspan_add_model(balls.scene, &ball, &balls.object) == ARCSPAN_OK);
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  const auto one = screen.pixels;
  REQUIRE(arcspan_add_model(balls.scene, &ball, &balls.object) == ARCSPAN_OK);
  REQUIRE(arcspan_set_position(balls.scene, balls.object, {ARCSPAN_LENGTH(0.5), 0, 0}) == ARCSPAN_OK);
  lv_arcspan_view_update(view);
  screen.refresh();
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
  CHECK((screen.pixels != one));
  lv_arcspan_view_set_turned(view, 2);
  screen.refresh();
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_INVALID_ARGUMENT);
  CHECK(lv_arcspan_view_get_dropped(view) == 1);
}

TEST_CASE("another scene may be shown in a flush, out of sight, and before a snapshot") {
  BallScene first;
  BallScene second;
  REQUIRE(arcspan_set_scale(second.scene, second.object, ARCSPAN_LENGTH(0.4)) == ARCSPAN_OK);
  std::vector<std::uint8_t> expected;
  {
    Screen screen;
    lv_obj_t* const view = make_view(second);
    lv_arcspan_view_set_turned(view, LV_ARCSPAN_NO_OBJECT);
    REQUIRE(arcspan_set_scale(second.scene, second.object, ARCSPAN_LENGTH(0.4)) == ARCSPAN_OK);
    expected = screen.redrawn();
  }
  Screen screen({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_PARTIAL, 8});
  lv_obj_t* const view = make_view(first);
  lv_arcspan_view_set_turned(view, LV_ARCSPAN_NO_OBJECT);
  const auto before = screen.redrawn();
  struct Change {
    lv_obj_t* view;
    arcspan_scene* scene;
  } change{view, second.scene};
  SECTION("in a flush") {
    screen.flush_data = &change;
    screen.in_flush = [](void* data) {
      const auto& wanted = *static_cast<Change*>(data);
      lv_arcspan_view_set_scene(wanted.view, wanted.scene);
    };
    CHECK((screen.redrawn() == before));
    screen.in_flush = nullptr;
  }
  SECTION("out of sight") {
    lv_obj_set_pos(view, 1000, 10);
    screen.refresh();
    lv_arcspan_view_set_scene(view, second.scene);
    screen.refresh();
    lv_obj_set_pos(view, 20, 10);
  }
#if LV_USE_SNAPSHOT
  SECTION("before a snapshot") {
    lv_arcspan_view_set_scene(view, second.scene);
    lv_draw_buf_t* const picture = lv_snapshot_take(view, LV_COLOR_FORMAT_ARGB8888);
    REQUIRE(picture != nullptr);
    lv_draw_buf_destroy(picture);
  }
#endif
  screen.refresh();
  CHECK((screen.pixels == expected));
  CHECK((screen.redrawn() == expected));
}

TEST_CASE(
    "a view of a scene whose object another view turns shows it as it is turned, made before or after") {
  const bool turns_first = GENERATE(true, false);
  Screen screen;
  BallScene balls;
  lv_obj_t* views[] = {make_view(balls), make_view(balls)};
  lv_obj_t* const turning = views[turns_first ? 0 : 1];
  lv_obj_t* const other = views[turns_first ? 1 : 0];
  lv_arcspan_view_set_turned(other, LV_ARCSPAN_NO_OBJECT);
  lv_obj_set_size(turning, 20, 20);
  screen.refresh();
  const auto before = screen.pixels;
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(0.5));
  lv_arcspan_view_update(other);
  screen.refresh();
  const auto once = screen.pixels;
  CHECK((once != before));
  lv_arcspan_view_update(other);
  screen.refresh();
  CHECK((screen.pixels == once));
}

TEST_CASE(
    "a view of another display shows the object as it is turned, whichever display is refreshed first") {
  Screen screen;
  lv_display_t* const own = lv_display_get_default();
  lv_display_t* const second = lv_display_create(40, 40);
  std::vector<std::uint8_t> buffer(40 * 40 * 2);
  lv_display_set_buffers(second, buffer.data(), nullptr, static_cast<std::uint32_t>(buffer.size()),
                         LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_display_set_flush_cb(second, [](lv_display_t* display, const lv_area_t*, std::uint8_t*) {
    lv_display_flush_ready(display);
  });
  BallScene balls;
  lv_obj_t* const other = make_view(balls);
  lv_arcspan_view_set_turned(other, LV_ARCSPAN_NO_OBJECT);
  lv_display_set_default(second);
  lv_obj_t* const turning = make_view(balls);
  lv_display_set_default(own);
  screen.refresh();
  lv_refr_now(second);
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(0.5));
  lv_arcspan_view_update(other);
  screen.refresh();
  const auto once = screen.pixels;
  lv_refr_now(second);
  lv_arcspan_view_update(other);
  screen.refresh();
  CHECK((screen.pixels == once));
  // Where both turn it, each shows it as it turns it itself.
  lv_arcspan_view_set_turned(other, balls.object);
  lv_arcspan_view_set_scale(other, ARCSPAN_LENGTH(0.75));
  screen.refresh();
  const auto own_scale = screen.pixels;
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(0.25));
  lv_arcspan_view_update(other);
  screen.refresh();
  CHECK((screen.pixels == own_scale));
  lv_arcspan_view_set_turned(other, LV_ARCSPAN_NO_OBJECT);
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(0.5));
  lv_refr_now(second);
  lv_display_delete(second);
  lv_arcspan_view_update(other);
  screen.refresh();
  CHECK((screen.pixels == once));
}

TEST_CASE("a view that is turned before its first layout turns the object for another display, too") {
  Screen screen;
  lv_display_t* const own = lv_display_get_default();
  lv_display_t* const second = lv_display_create(40, 40);
  BallScene balls;
  lv_obj_t* const other = make_view(balls);
  lv_arcspan_view_set_turned(other, LV_ARCSPAN_NO_OBJECT);
  lv_display_set_default(second);
  lv_obj_t* const turning = make_view(balls);
  lv_display_set_default(own);
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(0.5));
  screen.refresh();
  const auto first = screen.pixels;
  lv_arcspan_view_update(other);
  lv_obj_update_layout(turning);
  screen.refresh();
  CHECK((screen.pixels == first));
  lv_arcspan_view_set_scale(turning, ARCSPAN_LENGTH(1));
  lv_arcspan_view_update(other);
  screen.refresh();
  CHECK((screen.pixels != first));
}

TEST_CASE("a hidden view does not turn the object that another one turns") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  lv_obj_t* const hidden = make_view(balls);
  lv_obj_set_hidden(hidden, true);
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  screen.refresh();
  const auto pixels = screen.pixels;
  lv_obj_delete(hidden);
  lv_arcspan_view_update(view);
  screen.refresh();
  CHECK((screen.pixels == pixels));
}

TEST_CASE("a view that an event of the refresh shows turns its object for it") {
  Screen screen;
  BallScene balls;
  const auto show = [](lv_event_t* e) {
    if (lv_obj_t* const view = *static_cast<lv_obj_t**>(lv_event_get_user_data(e)))
      lv_obj_set_hidden(view, false);
  };
  lv_obj_t* hidden = nullptr;
  lv_display_add_event_cb(lv_display_get_default(), show, LV_EVENT_REFR_START, &hidden);
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  lv_obj_set_hidden(view, true);
  screen.refresh();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  hidden = view;
  screen.refresh();
  const auto pixels = screen.pixels;
  lv_arcspan_view_update(view);
  screen.refresh();
  CHECK((screen.pixels == pixels));
}

TEST_CASE("an event of the refresh may turn the object of a view that was changed before, or another one") {
  Screen screen;
  BallScene balls;
  BallScene others;
  struct Change {
    lv_obj_t* view;
    arcspan_scene* scene;
  } change{nullptr, GENERATE(true, false) ? others.scene : balls.scene};
  const auto turn = [](lv_event_t* e) {
    const auto& wanted = *static_cast<Change*>(lv_event_get_user_data(e));
    if (wanted.view == nullptr) return;
    lv_arcspan_view_set_scene(wanted.view, wanted.scene);
    lv_arcspan_view_set_rotation(wanted.view, {1 << 30, 1 << 29, 1 << 28, 0});
    lv_arcspan_view_set_scale(wanted.view, ARCSPAN_LENGTH(0.6));
  };
  lv_display_add_event_cb(lv_display_get_default(), turn, LV_EVENT_REFR_START, &change);
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.5));
  change.view = view;
  screen.refresh();
  const auto pixels = screen.pixels;
  change.view = nullptr;
  lv_arcspan_view_update(view);
  screen.refresh();
  CHECK((screen.pixels == pixels));
}

TEST_CASE("an object that follows the turned one in an event of the refresh is drawn with it") {
  struct Follower {
    arcspan_scene* scene;
    arcspan_object object;
    lv_obj_t* view;
  };
  Screen screen;
  const arcspan_scene_limits two_balls{2, 0};
  std::vector<unsigned char> memory(arcspan_scene_bytes(&two_balls));
  BallScene balls;
  REQUIRE(arcspan_scene_make(memory.data(), memory.size(), &two_balls, &balls.scene) == ARCSPAN_OK);
  Follower follower{balls.scene, 0, nullptr};
  REQUIRE(arcspan_add_model(balls.scene, &ball, &balls.object) == ARCSPAN_OK);
  REQUIRE(arcspan_add_model(balls.scene, &ball, &follower.object) == ARCSPAN_OK);
  REQUIRE(arcspan_set_position(balls.scene, follower.object, {ARCSPAN_LENGTH(0.7), 0, 0}) == ARCSPAN_OK);
  follower.view = make_view(balls);
  const auto follow = [](lv_event_t* e) {
    const auto& wanted = *static_cast<Follower*>(lv_event_get_user_data(e));
    const arcspan_length scale = lv_arcspan_view_get_scale(wanted.view);
    CHECK(arcspan_set_scale(wanted.scene, wanted.object, scale) == ARCSPAN_OK);
  };
  const auto event = static_cast<lv_event_code_t>(LV_EVENT_REFR_START | LV_EVENT_PREPROCESS);
  lv_display_add_event_cb(lv_display_get_default(), follow, event, &follower);
  screen.refresh();
  lv_arcspan_view_set_scale(follower.view, ARCSPAN_LENGTH(0.5));
  screen.refresh();
  const auto pixels = screen.pixels;
  lv_arcspan_view_update(follower.view);
  screen.refresh();
  CHECK((screen.pixels == pixels));
}

TEST_CASE("the view of a widget is there to pick in, from the first frame on") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  CHECK(lv_arcspan_view_get_view(view) == nullptr);
  lv_obj_update_layout(view);
  std::uint32_t key = LV_KEY_RIGHT;
  lv_obj_send_event(view, LV_EVENT_KEY, &key);
  CHECK(lv_arcspan_view_get_rotation(view).y == 0);
  screen.refresh();
  arcspan_picked picked;
  REQUIRE(arcspan_pick(lv_arcspan_view_get_view(view), 50, 40, &picked) == ARCSPAN_OK);
  CHECK(picked.found == 1);
  CHECK(picked.object == balls.object);
  REQUIRE(arcspan_pick(lv_arcspan_view_get_view(view), 0, 0, &picked) == ARCSPAN_OK);
  CHECK(picked.found == 0);
}

TEST_CASE("a view that a layout resizes has its new size in the next refresh") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const box = lv_obj_create(lv_screen_active());
  lv_obj_set_size(box, 140, 100);
  lv_obj_t* const view = make_view(balls);
  lv_obj_set_parent(view, box);
  lv_obj_set_pos(view, 0, 0);
  lv_obj_set_size(view, LV_PCT(100), LV_PCT(100));
  screen.refresh();
  lv_obj_set_size(box, 80, 90);
  screen.refresh();
  const auto resized = screen.pixels;
  lv_arcspan_view_update(view);
  screen.refresh();
  CHECK((screen.pixels == resized));
}

TEST_CASE("a view that is deleted when a layout changes a size is not used any more") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const parent = lv_obj_create(lv_screen_active());
  lv_obj_set_parent(make_view(balls), parent);
  lv_obj_t* const other = make_view(balls);
  screen.refresh();
  const auto clean = [](lv_event_t* e) { lv_obj_clean(lv_event_get_target_obj(e)); };
  lv_obj_add_event_cb(parent, clean, LV_EVENT_SIZE_CHANGED, nullptr);
  lv_obj_set_width(parent, 60);
  screen.refresh();
  CHECK(lv_obj_get_child_count(parent) == 0);
  CHECK(lv_arcspan_view_get_status(other) == ARCSPAN_OK);
  const auto pixels = screen.pixels;
  CHECK((screen.redrawn() == pixels));
}

#if LV_USE_SNAPSHOT
std::vector<std::uint8_t> snapshot_of(lv_obj_t* view) {
  lv_draw_buf_t* const picture = lv_snapshot_take(view, LV_COLOR_FORMAT_ARGB8888);
  REQUIRE(picture != nullptr);
  std::vector<std::uint8_t> bytes(picture->data, picture->data + picture->data_size);
  lv_draw_buf_destroy(picture);
  return bytes;
}

TEST_CASE("a snapshot shows a view as it is now, and so does the next refresh") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  SECTION("with another scale") { lv_arcspan_view_set_scale(view, ARCSPAN_LENGTH(0.3)); }
  SECTION("with another size") { lv_obj_set_size(view, 40, 40); }
  const auto picture = snapshot_of(view);
  screen.refresh();
  CHECK((snapshot_of(view) == picture));
  const auto pixels = screen.pixels;
  CHECK((screen.redrawn() == pixels));
}

TEST_CASE("a snapshot is as opaque as LVGL draws it, whatever holds the view") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  const auto picture = snapshot_of(view);
  lv_obj_set_style_opa(lv_screen_active(), LV_OPA_50, 0);
  SECTION("with an opacity of its own, too") { lv_obj_set_style_opa(view, LV_OPA_50, 0); }
  CHECK((snapshot_of(view) == picture));
}

TEST_CASE("a hidden view forgets a scene that was taken away") {
  Screen screen;
  auto balls = std::make_unique<BallScene>();
  lv_obj_t* const view = make_view(*balls);
  screen.refresh();
  lv_obj_set_hidden(view, true);
  screen.refresh();
  lv_arcspan_view_set_scene(view, nullptr);
  screen.refresh();
  balls.reset();
  CHECK(lv_arcspan_view_get_view(view) == nullptr);
  (void)snapshot_of(view);
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_NOT_READY);
}
#endif

TEST_CASE("a view without a content area drops no frame, and is drawn again when it has one") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  screen.refresh();
  const auto expected = screen.pixels;
  lv_arcspan_view_set_scene(view, nullptr);
  screen.refresh();
  const auto empty = screen.pixels;
  lv_arcspan_view_set_scene(view, balls.scene);
  screen.refresh();
  for (const bool of_width : {false, true}) {
    if (of_width) lv_obj_set_style_pad_hor(view, 200, 0);
    lv_obj_set_style_pad_ver(view, of_width ? 0 : 200, 0);
    screen.refresh();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_NOT_READY);
    CHECK((screen.pixels == empty));
  }
  lv_obj_set_style_pad_all(view, 0, 0);
  screen.refresh();
  CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_OK);
  CHECK(lv_arcspan_view_get_dropped(view) == 0);
  CHECK((screen.pixels == expected));
}

/// Lets LVGL run for half a second.
void run_timers() {
  for (int i = 0; i < 20; ++i) {
    lv_tick_inc(25);
    lv_timer_handler();
  }
}

TEST_CASE("a view that lacked memory asks for a refresh; for another reason nothing is drawn again") {
  Screen screen;
  BallScene balls;
  lv_obj_t* const view = make_view(balls);
  run_timers();
  const auto expected = screen.pixels;
  SECTION("of the view") {
    lv_arcspan_view_set_scene(view, nullptr);
    run_timers();
    fail_allocations_from(2000);
    lv_arcspan_view_set_scene(view, balls.scene);
    run_timers();
    CHECK(lv_arcspan_view_get_dropped(view) > 0);
    fail_allocations_from(0);
    run_timers();
    CHECK((screen.pixels == expected));
  }
  SECTION("of a layer") {
    fail_allocations_from(1500);
    lv_obj_set_style_opa(view, LV_OPA_50, 0);
    run_timers();
    CHECK(lv_arcspan_view_get_dropped(view) > 0);
    const auto without = screen.pixels;
    fail_allocations_from(0);
    run_timers();
    CHECK((screen.pixels != without));
  }
  SECTION("a light that models in flash are not made for") {
    const arcspan_light dim{{0, 0, ARCSPAN_LENGTH(1)}, 0, ARCSPAN_SHARE(0.5), {32768, 32768, 32768}};
    REQUIRE(arcspan_set_lights(balls.scene, &dim, 1, {32768, 32768, 32768}) == ARCSPAN_OK);
    lv_arcspan_view_update(view);
    run_timers();
    CHECK(lv_arcspan_view_get_status(view) == ARCSPAN_LIGHT_CHANGED);
    const std::uint32_t flushes = screen.flushes;
    run_timers();
    CHECK(screen.flushes == flushes);
  }
}

TEST_CASE("depths of fewer rows than asked for draw the same, in strips") {
  const auto expected = shown({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_FULL});
  fail_allocations_from(6000);  // of the view there are fewer, of depths more
  CHECK((shown({LV_COLOR_FORMAT_RGB565, LV_DISPLAY_RENDER_MODE_FULL}) == expected));
}

TEST_CASE(
    "an update without a scene, a scene that is taken away, two widgets, deletion and a second lv_init()") {
  BallScene balls;
  for (int i = 0; i < 2; ++i) {
    Screen screen;
    const auto empty = screen.redrawn();
    lv_obj_t* const view = lv_arcspan_view_create(lv_screen_active());
    lv_obj_remove_style_all(view);
    lv_obj_set_pos(view, 20, 10);
    lv_obj_set_size(view, 100, 80);
    screen.refresh();
    CHECK((screen.pixels == empty));
    lv_arcspan_view_set_scene(view, balls.scene);
    screen.refresh();
    const auto one = screen.pixels;
    CHECK(one != empty);
    lv_arcspan_view_set_scene(view, nullptr);
    screen.refresh();
    CHECK((screen.pixels == empty));
    lv_arcspan_view_set_scene(view, balls.scene);
    lv_obj_t* const second = lv_arcspan_view_create(lv_screen_active());
    lv_obj_remove_style_all(second);
    lv_obj_set_size(second, 30, 30);
    lv_arcspan_view_set_scene(second, balls.scene);
    screen.refresh();
    CHECK((screen.pixels != one));
    lv_obj_delete(second);
    screen.refresh();
    CHECK((screen.pixels == one));
  }
}

}  // namespace
