// SPDX-License-Identifier: MIT
#include <arcspan/draw_lines.hpp>
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/overlay/line.hpp>
#include <arcspan/overlay/needle.hpp>
#include <arcspan/overlay/rectangle.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/xrgb8888.hpp>

#include <catch2/catch.hpp>
#include <tests/pipeline/overlay/overlay_support.hpp>
#include <tests/support/random.hpp>
#include <tests/support/strict_sink.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

using namespace arcspan;
using namespace arcspan::overlay;
using namespace arcspan::test;

namespace {

constexpr Rgb8 kInk = TextPicture::kInk;
constexpr std::int32_t kFar[] = {INT32_MIN, INT32_MIN + 1, -1'000'000'000, -7,       0, 5,
                                 900,       1'000'000'000, INT32_MAX - 1,  INT32_MAX};

__extension__ using Wide = __int128;

/// floor(a / b + 1/2), b > 0.
std::int64_t rounded(Wide a, Wide b) {
  const Wide twice = 2 * a + b;
  Wide quotient = twice / (2 * b);
  if (quotient * 2 * b > twice) --quotient;
  return static_cast<std::int64_t>(quotient);
}

/// Whether a line has a pixel: computed anew for each, with the line a little further left.
bool on_line(Point a, Point b, std::int64_t x, std::int64_t y) {
  const std::int64_t dx = std::int64_t{b.x} - a.x;
  const std::int64_t dy = std::int64_t{b.y} - a.y;
  if (std::abs(dx) >= std::abs(dy)) {
    if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) return false;
    if (dx == 0) return y == a.y;
    if (dx < 0) return on_line(b, a, x, y);
    const Wide below = Wide{std::abs(dy)} * (x - a.x);
    return y == a.y + (dy < 0 ? -1 : 1) * rounded(below, dx);
  }
  if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y)) return false;
  if (dy < 0) return on_line(b, a, x, y);
  return x == a.x - rounded(-Wide{dx} * (y - a.y), dy);
}

}  // namespace

TEST_CASE("rectangles are filled and framed, each pixel once") {
  StrictSink sink({0, 0, 10, 6});
  CHECK(fill_rectangle(sink, {7, -3, 20, 2}, kInk) == Status::kOk);
  CHECK(draw_frame(sink, {1, 1, 6, 5}, kInk) == Status::kOk);
  CHECK(draw_frame(sink, {7, 3, 10, 6}, kInk, 2) == Status::kOk);
  CHECK(sink.faults() == SinkFaults{});
  CHECK(sink.text() == "       ###\n ##### ###\n #   #\n #   # ###\n ##### ###\n       ###\n");
  sink.clear();
  CHECK(draw_frame(sink, {-2, -2, 12, 8}, kInk, 3) == Status::kOk);
  CHECK(sink.text() == "##########\n#        #\n#        #\n#        #\n#        #\n##########\n");
  CHECK(sink.faults() == SinkFaults{});
  sink.clear();
  CHECK(draw_frame(sink, {0, 0, 5, 5}, kInk, 0) == Status::kOk);
  CHECK(draw_frame(sink, {0, 0, 5, 5}, kInk, INT32_MIN) == Status::kOk);
  CHECK(fill_rectangle(sink, {5, 5, 5, 6}, kInk) == Status::kOk);
  CHECK(sink.drawn() == 0);
  for (const std::int32_t left : kFar) {
    for (const std::int32_t right : kFar) {
      sink.clear();
      CHECK(fill_rectangle(sink, {left, left, right, right}, kInk) == Status::kOk);
      for (const std::int32_t thickness : {1, 900, INT32_MAX})
        CHECK(draw_frame(sink, {left, left, right, right}, kInk, thickness) == Status::kOk);
      CHECK(sink.faults().outside == 0);
    }
  }
}

TEMPLATE_TEST_CASE("rectangles of some opacity mix their colour with what is there", "", Rgb565, Xrgb8888,
                   Gray4) {
  std::array<typename TestType::Word, hal::Framebuffer<TestType>::words(8, 4)> words{};
  hal::Framebuffer<TestType> frame(words, 8, 4);
  const double step = std::is_same_v<TestType, Gray4>    ? 17
                      : std::is_same_v<TestType, Rgb565> ? 255.0 / 63
                                                         : 1;
  const double colour = TestType::decode(TestType::encode(Rgb8{30, 30, 30})).g;
  for (std::uint32_t opacity = 0; opacity <= 40; ++opacity) {
    frame.clear({200, 200, 200});
    const double before = frame.pixel(0, 0).g;
    REQUIRE(ok(fill_rectangle(frame, {2, 1, 90, 3}, {30, 30, 30}, opacity)));
    const double share = std::min(opacity, 32u) / 32.0;
    for (std::int32_t y = 0; y < 4; ++y) {
      for (std::int32_t x = 0; x < 8; ++x) {
        const bool within = x >= 2 && y >= 1 && y < 3;
        const double expected = within ? before + share * (colour - before) : before;
        CHECK(frame.pixel(x, y).g == Approx(expected).margin(within ? step : 0));
      }
    }
  }
  CHECK(fill_rectangle(frame, {3, 3, 3, 4}, {}, 9) == Status::kOk);
}

TEST_CASE("lines have the pixels that their definition says, in both directions") {
  StrictSink sink({2, 1, 32, 25});
  Random random(3);
  for (int i = share_of(3000); i > 0; --i) {
    const auto end = [&] { return random.chance(0.15) ? kFar[random.bits() % 10] : random.integer(-20, 50); };
    const Point a{end(), end()};
    const Point b = random.chance(0.05) ? a : Point{end(), end()};
    for (const bool turned : {false, true}) {
      sink.clear();
      CHECK(draw_line(sink, turned ? b : a, turned ? a : b, kInk) == Status::kOk);
      bool same = sink.faults() == SinkFaults{};
      for (std::int32_t y = 1; y < 25; ++y)
        for (std::int32_t x = 2; x < 32; ++x)
          same = same && (sink.cell(x, y).count == 1) == on_line(a, b, x, y);
      CAPTURE(a.x, a.y, b.x, b.y);
      CHECK(same);
    }
  }
}

TEST_CASE("lines are those of draw_lines() between the middles of pixels") {
  constexpr Viewport kView{64, 48};
  StrictSink sink({0, 0, 64, 48});
  StrictSink expected({0, 0, 64, 48});
  Random random(5);
  for (int i = share_of(2000); i > 0; --i) {
    const Point a{random.integer(0, 63), random.integer(0, 47)};
    const Point b{random.integer(0, 63), random.integer(0, 47)};
    const auto raster = [](Point p) {
      return RasterPosition{static_cast<std::int16_t>((p.x - 32) * 16 + 8),
                            static_cast<std::int16_t>((p.y - 24) * 16 + 8), 30000};
    };
    sink.clear();
    expected.clear();
    CHECK(draw_line(sink, a, b, kInk) == Status::kOk);
    const auto colour = Unlit::lighting(kInk);
    const NoDepth depth;
    arcspan::detail::LineStage<Unlit, StrictSink, NoDepth> stage(kView, colour, expected, depth, {});
    stage.draw(raster(a), raster(b));
    CAPTURE(a.x, a.y, b.x, b.y);
    CHECK(sink.text() == expected.text());
  }
}

TEST_CASE("needles point upwards at angle 0 and turn clockwise") {
  const auto drawn = [](Turn angle) {
    StrictSink sink({0, 0, 9, 9});
    CHECK(draw_needle(sink, {{4, 4}, angle, 4, 3, 1}, kInk) == Status::kOk);
    CHECK(sink.faults() == SinkFaults{});
    return sink.text();
  };
  const std::string up = drawn({0});
  CHECK(up == "    #\n    #\n    #\n   ###\n   ###\n\n\n\n\n");
  const std::string right = drawn({0x4000});
  CHECK(right == "\n\n\n   ###\n   #####\n   ###\n\n\n\n");
  CHECK(drawn({0xC000}) != right);
}

TEST_CASE("needles cover the pixels whose middles lie within them, and their rectangle all of these") {
  Random random(11);
  StrictSink sink({0, 0, 120, 100});
  for (int i = share_of(500); i > 0; --i) {
    const Needle needle{{random.integer(-10, 130), random.integer(-10, 110)},
                        {static_cast<std::uint16_t>(random.bits())},
                        random.integer(0, 90),
                        random.integer(1, 20),
                        random.integer(0, 30)};
    sink.clear();
    CHECK(draw_needle(sink, needle, kInk) == Status::kOk);
    CHECK(sink.faults() == SinkFaults{});
    const Rect rect = needle_rect(needle);
    const double angle = needle.angle.raw * 2 * std::numbers::pi / 65536;
    std::size_t wrong = 0;
    for (std::int32_t y = 0; y < 100; ++y) {
      for (std::int32_t x = 0; x < 120; ++x) {
        const double dx = x - needle.pivot.x;
        const double dy = y - needle.pivot.y;
        const double along = dx * std::sin(angle) - dy * std::cos(angle);
        const double across = std::abs(dx * std::cos(angle) + dy * std::sin(angle));
        const double length = needle.length + needle.tail;
        const double share = length == 0 ? 0 : (along + needle.tail) / length;
        const double half = needle.width / 2.0 + share * (0.5 - needle.width / 2.0);
        constexpr double kNear = 0.1;  // corners are rounded to sixteenths
        const bool inside =
            along > -needle.tail + kNear && along < needle.length - kNear && across < half - kNear;
        const bool outside =
            along < -needle.tail - kNear || along > needle.length + kNear || across > half + kNear;
        const bool covered = sink.cell(x, y).count != 0;
        wrong += (inside && !covered) || (outside && covered) ? 1u : 0u;
        if (!covered) continue;
        wrong += x < rect.left || x >= rect.right || y < rect.top || y >= rect.bottom ? 1u : 0u;
      }
    }
    CAPTURE(needle.pivot.x, needle.pivot.y, needle.angle.raw, needle.length, needle.width, needle.tail);
    CHECK(wrong == 0);
  }
}

TEST_CASE("thin needles have no gaps, and needles that are none are refused") {
  StrictSink sink({0, 0, 200, 200});
  for (std::uint32_t angle = 0; angle < 65536; angle += 331) {
    sink.clear();
    CHECK(draw_needle(sink, {{100, 100}, {static_cast<std::uint16_t>(angle)}, 90, 1, 0}, kInk) ==
          Status::kOk);
    const double turn = angle * 2 * std::numbers::pi / 65536;
    const double longer = std::max(std::abs(std::sin(turn)), std::abs(std::cos(turn)));
    CHECK(static_cast<double>(sink.drawn()) >= std::floor(90 * longer) - 2);
  }
  sink.clear();
  for (const Needle& wrong :
       {Needle{{5, 5}, {}, -1, 1, 0}, Needle{{5, 5}, {}, 5, 0, 0}, Needle{{5, 5}, {}, 5, 256, 0},
        Needle{{5, 5}, {}, 901, 1, 0}, Needle{{5, 5}, {}, 9, 1, -1}, Needle{{5, 5}, {}, 9, 1, INT32_MAX}}) {
    CHECK(draw_needle(sink, wrong, kInk) == Status::kInvalidArgument);
    CHECK(needle_rect(wrong).empty());
  }
  CHECK(sink.drawn() == 0);
  for (const std::int32_t x : kFar)
    for (const std::int32_t y : kFar)
      for (std::uint32_t angle = 0; angle < 65536; angle += 4099) {
        const Needle longest{{x, y}, {static_cast<std::uint16_t>(angle)}, 900, 255, 900};
        CHECK(draw_needle(sink, longest, kInk) == Status::kOk);
        (void)needle_rect(longest);
      }
  CHECK(sink.faults().outside == 0);
}

TEST_CASE("needles are drawn modulo 2^32, without overflow") {
  constexpr bool kDrawn = [] {  // a constant, where overflow is an error of the compiler
    std::uint8_t pixels[8 * 8] = {};
    hal::Framebuffer<Gray8> last(pixels, 8, 8, INT32_MAX - 8);
    const Status status = draw_needle(last, {{3, INT32_MIN + 2}, {}, 8, 1, 0}, {255, 255, 255});
    return ok(status) && pixels[8 * 7 + 3] == 255 && pixels[8 * 2 + 3] == 0;
  }();
  CHECK(kDrawn);
}
