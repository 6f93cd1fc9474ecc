// SPDX-License-Identifier: MIT
// Rectangles that are drawn and sent, on every panel, against the whole frame.
#include "benches.hpp"

#include <arcspan/pixel/background.hpp>
#include <arcspan/pixel/dither.hpp>

#include <catch2/catch.hpp>
#include <tests/support/random.hpp>
#include <tests/support/test_share.hpp>

#include <algorithm>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::bench;

namespace {

constexpr std::int32_t kRows = 8;

/// A glass whose rows end within a byte of the framebuffer.
struct NarrowSsd1306Bench : SolomonSpiBench<Ssd1306, sim::Ssd1306Model> {
  explicit NarrowSsd1306Bench(const PanelSettings& s = {},
                              const Glass& g = {12, 64, 50, 0, true, true, false, false})
      : SolomonSpiBench(g, s) {}
};

/// A panel with page mode and the picture that its glass should show.
template <class Bench>
struct AreaBench {
  using Driver = typename Bench::Driver;
  using Layout = typename Driver::Layout;
  using Mode = PageMode<Driver>;
  using Format = typename Layout::Format;

  Bench bench;
  std::vector<typename Mode::Frame::Word> band;
  std::vector<std::uint8_t> wire;
  Mode mode;
  Scene<Bench> shown;
  std::vector<Rect> parts;  ///< drawn by the last draw()

  explicit AreaBench(Orientation o)
      : bench(PanelSettings{.orientation = o}),
        band(Mode::Frame::words(bench.panel.width(), kRows)),
        wire(wire_bytes<Driver>(bench.panel.width(), kRows)),
        mode(bench.panel, band, wire, kRows),
        shown(bench.panel, 1) {
    REQUIRE(bench.panel.start() == Status::kOk);
    REQUIRE(send_whole(bench, shown.frame) == Status::kOk);
  }

  /// A function that draws the part of `picture` that is asked for.
  auto draw(const Scene<Bench>& picture) {
    parts.clear();
    return [&, this](typename Mode::Window& window) {
      parts.push_back(window.bounds());
      const std::span<const typename Format::Word> words(picture.memory);
      return draw_background(window,
                             BackgroundPicture<Format>{words, bench.panel.width(), bench.panel.height()});
    };
  }
  /// Notes that the glass has to show a rectangle of `picture`.
  void note(const Scene<Bench>& picture, const Rect& area) {
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      for (std::int32_t x = area.left; x < area.right; ++x) {
        typename Format::Cursor(shown.frame.row(y), x)
            .write(typename Format::Cursor(picture.frame.row(y), x).read());
      }
    }
  }
  /// Checks the glass.
  void check() {
    CHECK(bench.device.picture() == expected(shown.frame, bench.panel.settings().orientation));
    CHECK(complaints(bench) == "");
  }
  [[nodiscard]] std::int64_t drawn_pixels() const {
    std::int64_t pixels = 0;
    for (const Rect& part : parts) pixels += std::int64_t{part.width()} * part.height();
    return pixels;
  }
};

Rect random_rect(test::Random& random, const Rect& all) {
  const std::int32_t x = random.integer(-9, all.right - 1);
  const std::int32_t y = random.integer(-9, all.bottom - 1);
  return {x, y, x + random.integer(1, all.right), y + random.integer(1, all.bottom)};
}

Rect clipped(const Rect& r, const Rect& all) {
  return {std::max(r.left, 0), std::max(r.top, 0), std::min(r.right, all.right),
          std::min(r.bottom, all.bottom)};
}

}  // namespace

TEMPLATE_TEST_CASE("a rectangle of the picture is drawn and sent, and nothing else", "", Ili9341Bench,
                   St7789Bench, Ssd1351SmallBench, Ssd0323Bench, Ssd0323MiddleBench, Ssd1306Bench,
                   NarrowSsd1306Bench, Ssd1306I2cBench) {
  test::Random random(4541);
  for (const Orientation o : {Orientation::k0, Orientation::k90, Orientation::k180, Orientation::k270}) {
    AreaBench<TestType> test(o);
    const Rect all = test.bench.panel.bounds();
    for (int i = 0; i < test::share_of(10); ++i) {
      const Rect area = random_rect(random, all);
      const Scene<TestType> next(test.bench.panel, static_cast<unsigned>(2 + i));
      const std::uint64_t before = test.bench.bus.count().bytes;
      REQUIRE(test.mode.show_area(area, test.draw(next)) == Status::kOk);
      const std::uint64_t bytes = test.bench.bus.count().bytes - before;
      const Rect seen = clipped(area, all);
      if (seen.empty()) {
        CHECK(bytes == 0);
        continue;
      }
      const Rect sent = widened<typename TestType::Driver::Layout>(seen, o);
      Rect drawn{};
      for (const Rect& part : test.parts) {
        CHECK(std::int64_t{part.width()} * part.height() <= std::int64_t{all.right} * kRows);
        drawn = bounding_rect(drawn, part);
      }
      CHECK(drawn == sent);
      CHECK(test.drawn_pixels() == std::int64_t{sent.width()} * sent.height());
      CHECK(test.parts.size() <= static_cast<std::size_t>(all.bottom / kRows + 1));
      const std::size_t pixels = TestType::Driver::Layout::bytes(sent);
      CHECK(bytes >= pixels);
      if constexpr (TestType::kPins) CHECK(bytes < pixels + 16 * test.parts.size());  // windows
      test.note(next, sent);
      test.check();
    }
    // The whole picture is a rectangle too.
    const Scene<TestType> next(test.bench.panel, 77);
    REQUIRE(test.mode.show_area(all, test.draw(next)) == Status::kOk);
    test.note(next, all);
    test.check();
  }
}

TEST_CASE("a band is dithered by a framebuffer of the dithered format over its memory") {
  using Dithers = Framebuffer<Dithered<Mono>>;
  constexpr VerticalGradient kGradient{{0, 0, 0}, {255, 255, 255}, 64};
  AreaBench<Ssd1306Bench> bench(Orientation::k0);
  REQUIRE(ok(bench.mode.show([&](Framebuffer<Mono>& band) {
    const Rect rows = band.bounds();
    Dithers dithers(bench.band, rows.width(), rows.height(), rows.top);
    return draw_background(dithers, kGradient);
  })));
  Dithers whole(bench.shown.memory, bench.bench.panel.width(), bench.bench.panel.height());
  REQUIRE(ok(draw_background(whole, kGradient)));
  bench.check();
}

TEST_CASE("two rectangles are sent as one if that takes no more pixels") {
  AreaBench<Ili9341Bench> test(Orientation::k0);
  const Scene<Ili9341Bench> next(test.bench.panel, 2);
  const auto drawn = [&](const Rect& before, const Rect& now) {
    REQUIRE(test.mode.show_areas(before, now, test.draw(next)) == Status::kOk);
    for (const Rect& part : test.parts) test.note(next, part);
    test.check();
    return test.drawn_pixels();
  };
  CHECK(drawn({10, 10, 20, 20}, {12, 12, 22, 22}) == 12 * 12);
  CHECK(drawn({10, 10, 20, 20}, {20, 10, 30, 20}) == 20 * 10);
  CHECK(test.parts.size() == 1);
  CHECK(drawn({10, 10, 20, 20}, {19, 19, 29, 29}) == 2 * 10 * 10);
  CHECK(drawn({10, 10, 20, 20}, {200, 300, 240, 320}) == 10 * 10 + 40 * 20);
  CHECK(drawn({10, 10, 20, 20}, {}) == 10 * 10);
  CHECK(drawn({}, {10, 10, 20, 20}) == 10 * 10);
  CHECK(drawn({}, {}) == 0);
  // Parts outside of the panel do not count.
  constexpr Rect kWhole{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
  CHECK(drawn({10, 10, 20, 20}, kWhole) == 240 * 320);
  CHECK(drawn({-900, 10, 20, 20}, {200, 10, 900, 20}) == 20 * 10 + 40 * 10);
  CHECK(drawn({INT32_MAX, 0, INT32_MIN, 9}, {INT32_MIN, 5, -9, 9}) == 0);
}

TEST_CASE("a rectangle that cannot be drawn or sent says why, and sends nothing") {
  AreaBench<Ssd1306Bench> test(Orientation::k0);
  const Scene<Ssd1306Bench> next(test.bench.panel, 2);
  const std::uint64_t before = test.bench.bus.count().bytes;
  const auto draw = test.draw(next);
  using Mode = AreaBench<Ssd1306Bench>::Mode;
  auto& panel = test.bench.panel;
  const Rect area{8, 8, 16, 16};
  CHECK(
      Mode(panel, std::span(test.band).first(test.band.size() - 1), test.wire, kRows).show_area(area, draw) ==
      Status::kBufferTooSmall);
  CHECK(
      Mode(panel, test.band, std::span(test.wire).first(test.wire.size() - 1), kRows).show_area(area, draw) ==
      Status::kBufferTooSmall);
  CHECK(Mode(panel, test.band, test.wire, 7).show_area(area, draw) == Status::kInvalidArgument);
  CHECK(test.mode.show_area({}, draw) == Status::kOk);
  CHECK(test.mode.show_area({INT32_MIN, INT32_MIN, -1, INT32_MAX}, draw) == Status::kOk);
  CHECK(test.mode.show_area(area, [](auto&) { return Status::kIndexOutOfRange; }) ==
        Status::kIndexOutOfRange);
  CHECK(test.mode.show_areas(area, {0, 0, 128, 64}, [](auto&) { return Status::kIndexOutOfRange; }) ==
        Status::kIndexOutOfRange);
  CHECK(test.parts.empty());
  CHECK(test.bench.bus.count().bytes == before);
  REQUIRE(panel.sleep() == Status::kOk);
  CHECK(test.mode.show_area(area, draw) == Status::kNotReady);
  REQUIRE(panel.wake() == Status::kOk);
  REQUIRE(test.mode.show_area({INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}, test.draw(next)) == Status::kOk);
  test.note(next, panel.bounds());
  test.check();
}

TEST_CASE("rectangles of a glass that no controller has are refused, however large it is") {
  // That their pixels are not counted by a product that overflows shows under sanitizers only.
  Ili9341Bench bench({}, {65535, 65535, 0, 0, false, false, false, false});
  std::uint16_t band[1];
  std::uint8_t wire[1];
  PageMode<Ili9341> mode(bench.panel, band, wire, 1);
  constexpr Rect kAll{0, 0, INT32_MAX, INT32_MAX};
  CHECK(mode.show_areas(kAll, kAll, [](auto&) { return Status::kOk; }) == Status::kBufferTooSmall);
}

TEST_CASE("a frame that is turned while it is drawn ends there, and the next one is right") {
  for (const Orientation o : {Orientation::k90, Orientation::k180, Orientation::k270}) {
    for (int way = 0; way < 3; ++way) {
      AreaBench<Ssd1351SmallBench> test(Orientation::k0);
      auto& panel = test.bench.panel;
      const auto turn = [&](auto&) { return panel.set({.orientation = o}); };
      std::vector<RowExtent> memory(Damage::extents(panel.height()));
      Damage damage(memory, panel.width(), panel.height());
      const Status status =
          way == 0   ? test.mode.show(turn)
          : way == 1 ? test.mode.show_area({0, 0, 96, 4}, turn)
                     : test.mode.show_changes(damage, [&](auto& sink, auto&) { return turn(sink); });
      CHECK(status == Status::kInvalidArgument);
      const Scene<Ssd1351SmallBench> next(panel, 2);
      REQUIRE(test.mode.show_area(panel.bounds(), test.draw(next)) == Status::kOk);
      CHECK(test.bench.device.picture() == expected(next.frame, o));
      CHECK(complaints(test.bench) == "");
    }
  }
}
