// SPDX-License-Identifier: MIT
// What every panel has to do, with its driver and the model of its controller end to end.
#include "benches.hpp"

#include <arcspan/pixel/rgb565_swapped.hpp>

#include <catch2/catch.hpp>

#include <bit>
#include <type_traits>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::bench;

#define ARCSPAN_EVERY_PANEL                                                                 \
  Ili9341Bench, St7789Bench, CustomDcsBench, Ssd1351Bench, Ssd1351SmallBench, Ssd0323Bench, \
      Ssd0323MiddleBench, Ssd1306Bench, Ssd1306I2cBench

namespace {

constexpr Orientation kOrientations[] = {Orientation::k0, Orientation::k90, Orientation::k180,
                                         Orientation::k270};

bool black(const sim::Picture& picture) {
  for (const Rgb8& c : picture.pixels) {
    if (c != Rgb8{}) return false;
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("a frame on the glass is the framebuffer, in every orientation", "", ARCSPAN_EVERY_PANEL) {
  for (const Orientation o : kOrientations) {
    TestType bench(PanelSettings{.orientation = o});
    REQUIRE(bench.panel.start() == Status::kOk);
    const Scene<TestType> scene(bench.panel);
    REQUIRE(send_whole(bench, scene.frame) == Status::kOk);
    CHECK(bench.device.picture() == expected(scene.frame, o));
    CHECK(complaints(bench) == "");
  }
}

TEMPLATE_TEST_CASE("the memory of a frame with swapped bytes is what a panel of 16-bit colours takes", "",
                   Ili9341Bench, St7789Bench, Ssd1351Bench) {
  TestType bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  const Scene<TestType> scene(bench.panel);
  const std::int32_t width = bench.panel.width();
  const std::int32_t height = bench.panel.height();
  // On a big-endian machine a word has its high byte first anyway.
  using Format = std::conditional_t<std::endian::native == std::endian::little, Rgb565Swapped, Rgb565>;
  std::vector<std::uint16_t> memory(Framebuffer<Format>::words(width, height));
  Framebuffer<Format> swapped(memory, width, height);
  for (std::int32_t y = 0; y < height; ++y) {
    auto cursor = swapped.open({y, 0, width});
    for (std::int32_t x = 0; x < width; ++x, cursor.next())
      cursor.write(Format::encode(scene.frame.pixel(x, y)));
  }
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(memory.data());
  REQUIRE(bench.panel.start_write(bench.panel.bounds(), {bytes, 2 * memory.size()}) == Status::kOk);
  REQUIRE(bench.panel.finish() == Status::kOk);
  CHECK(bench.device.picture() == expected(scene.frame, Orientation::k0));
  CHECK(complaints(bench) == "");
}

TEMPLATE_TEST_CASE("a partial update changes its area and nothing else", "", ARCSPAN_EVERY_PANEL) {
  for (const Orientation o : kOrientations) {
    TestType bench(PanelSettings{.orientation = o});
    REQUIRE(bench.panel.start() == Status::kOk);
    const Scene<TestType> before(bench.panel, 1);
    Scene<TestType> after(bench.panel, 1);
    REQUIRE(send_whole(bench, before.frame) == Status::kOk);
    const Scene<TestType> other(bench.panel, 2);
    const Rect area{16, 8, 32, 40};  // a multiple of every layout's steps
    using Format = typename TestType::Driver::Layout::Format;
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      for (std::int32_t x = area.left; x < area.right; ++x) {
        typename Format::Cursor(after.frame.row(y), x)
            .write(typename Format::Cursor(other.frame.row(y), x).read());
      }
    }
    const std::uint64_t bytes = bench.bus.count().bytes;
    std::vector<std::uint8_t> wire(512);
    REQUIRE(send_area(bench.panel, other.frame, area, wire) == Status::kOk);
    CHECK(bench.device.picture() == expected(after.frame, o));
    const std::size_t least = TestType::Driver::Layout::bytes(area);
    CHECK(bench.bus.count().bytes - bytes >= least);
    CHECK(bench.bus.count().bytes - bytes < 2 * least + 64);
    // An area between the steps takes the pixels around it along.
    REQUIRE(send_area(bench.panel, after.frame, {17, 9, 18, 10}, wire) == Status::kOk);
    CHECK(complaints(bench) == "");
  }
}

TEMPLATE_TEST_CASE("page mode gives the same picture, whatever the band", "", ARCSPAN_EVERY_PANEL) {
  using Driver = typename TestType::Driver;
  using Mode = PageMode<Driver>;
  for (const Orientation o : kOrientations) {
    for (const std::int32_t rows : {8, 24, 40}) {
      TestType bench(PanelSettings{.orientation = o});
      REQUIRE(bench.panel.start() == Status::kOk);
      std::vector<typename Mode::Frame::Word> band(Mode::Frame::words(bench.panel.width(), rows));
      std::vector<std::uint8_t> wire(wire_bytes<Driver>(bench.panel.width(), rows));
      Mode mode(bench.panel, band, wire, rows);
      const Scene<TestType> scene(bench.panel, 5);
      const auto draw = [](auto& frame) { return Scene<TestType>::paint(frame, 5), Status::kOk; };
      REQUIRE(mode.show(draw) == Status::kOk);
      CHECK(bench.device.picture() == expected(scene.frame, o));
      CHECK(complaints(bench) == "");
      // A failing band ends the frame; nothing is left under way.
      CHECK(mode.show([height = bench.panel.height()](auto& frame) {
        return frame.bounds().bottom < height ? Status::kOk : Status::kIndexOutOfRange;
      }) == Status::kIndexOutOfRange);
      CHECK(mode.show(draw) == Status::kOk);
      CHECK(bench.device.picture() == expected(scene.frame, o));
      CHECK(Mode(bench.panel, band, std::span(wire).first(wire.size() - 1), rows).show(draw) ==
            Status::kBufferTooSmall);
      CHECK(Mode(bench.panel, std::span(band).first(band.size() - 1), wire, rows).show(draw) ==
            Status::kBufferTooSmall);
      CHECK(Mode(bench.panel, band, wire, 0).show(draw) == Status::kInvalidArgument);
      CHECK(Mode(bench.panel, band, wire, 1000).show(draw) == Status::kInvalidArgument);
    }
  }
}

TEMPLATE_TEST_CASE("only changed areas are sent, and the picture is whole", "", ARCSPAN_EVERY_PANEL) {
  using Driver = typename TestType::Driver;
  using Mode = PageMode<Driver>;
  using Format = typename Driver::Layout::Format;
  for (const Orientation o : kOrientations) {
    TestType bench(PanelSettings{.orientation = o});
    REQUIRE(bench.panel.start() == Status::kOk);
    const std::int32_t width = bench.panel.width();
    const std::int32_t height = bench.panel.height();
    std::vector<typename Mode::Frame::Word> band(Mode::Frame::words(width, 8));
    std::vector<std::uint8_t> wire(wire_bytes<Driver>(width, 8));
    std::vector<RowExtent> extents(Damage::extents(height));
    Damage damage(extents, width, height);
    REQUIRE(damage.status() == Status::kOk);
    Mode mode(bench.panel, band, wire, 8);
    std::vector<typename Mode::Frame::Word> memory(Mode::Frame::words(width, height));
    std::uint64_t first_bytes = 0;
    // A square that moves; the last two frames are the same, then one is drawn after a disturbance.
    for (const std::int32_t at : {3, 11, 20, 20}) {
      const auto square = [at](auto& sink, const Rect& bounds) {
        for (std::int32_t y = at; y < at + 9; ++y) {
          if (y < bounds.top || y >= bounds.bottom) continue;
          const Span run{y, at + 1, 9};
          auto cursor = sink.open(run);
          for (int i = 0; i < 9; ++i, cursor.next()) cursor.write(Format::encode(Rgb8{255, 240, 250}));
          if (!ok(sink.close(run))) return Status::kTransferFailed;
        }
        return Status::kOk;
      };
      const std::uint64_t before = bench.bus.count().bytes;
      REQUIRE(mode.show_changes(damage, [&](auto& sink, auto& frame) {
        frame.clear({0, 0, 40});
        return square(sink, frame.bounds());
      }) == Status::kOk);
      const std::uint64_t bytes = bench.bus.count().bytes - before;
      typename Mode::Frame whole(memory, width, height);
      whole.clear({0, 0, 40});
      REQUIRE(square(whole, whole.bounds()) == Status::kOk);
      CHECK(bench.device.picture() == expected(whole, o));
      if (first_bytes == 0) first_bytes = bytes;
      CHECK((at == 3 || bytes < first_bytes / 2));
    }
    CHECK(complaints(bench) == "");
  }
}

TEMPLATE_TEST_CASE("changes are whole after the picture was turned by half", "", ARCSPAN_EVERY_PANEL) {
  using Driver = typename TestType::Driver;
  using Mode = PageMode<Driver>;
  using Format = typename Driver::Layout::Format;
  TestType bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  const std::int32_t width = bench.panel.width();
  const std::int32_t height = bench.panel.height();
  std::vector<typename Mode::Frame::Word> band(Mode::Frame::words(width, 8));
  std::vector<std::uint8_t> wire(wire_bytes<Driver>(width, 8));
  std::vector<RowExtent> extents(Damage::extents(height));
  Damage damage(extents, width, height);
  Mode mode(bench.panel, band, wire, 8);
  const auto pixel = [](auto& sink, const Rect& bounds) {
    const Span run{5, 3, 1};
    if (run.y < bounds.top || run.y >= bounds.bottom) return Status::kOk;
    sink.open(run).write(Format::encode(Rgb8{255, 240, 250}));
    return sink.close(run);
  };
  std::uint64_t bytes[3] = {};  // of a whole frame, of the one after a turn, and of one without a change
  for (std::size_t i = 0; i < 3; ++i) {
    const Orientation o = i == 0 ? Orientation::k0 : Orientation::k180;
    REQUIRE(bench.panel.set({.orientation = o}) == Status::kOk);
    const std::uint64_t before = bench.bus.count().bytes;
    REQUIRE(mode.show_changes(damage, [&](auto& sink, auto& frame) {
      frame.clear({0, 0, 40});
      return pixel(sink, frame.bounds());
    }) == Status::kOk);
    bytes[i] = bench.bus.count().bytes - before;
    std::vector<typename Mode::Frame::Word> memory(Mode::Frame::words(width, height));
    typename Mode::Frame whole(memory, width, height);
    whole.clear({0, 0, 40});
    REQUIRE(pixel(whole, whole.bounds()) == Status::kOk);
    CHECK(bench.device.picture() == expected(whole, o));
  }
  CHECK(bytes[1] == bytes[0]);
  CHECK(bytes[2] < bytes[0] / 2);
}

TEMPLATE_TEST_CASE("inversion, brightness, sleep and wake arrive", "", ARCSPAN_EVERY_PANEL) {
  TestType bench;
  CHECK(bench.panel.sleep() == Status::kNotReady);
  CHECK(bench.panel.wake() == Status::kNotReady);
  const std::uint8_t byte[] = {0, 0};
  CHECK(bench.panel.start_write({0, 0, 1, 1}, byte) == Status::kNotReady);
  CHECK(bench.bus.count().bytes == 0);
  CHECK(black(bench.device.picture()));
  REQUIRE(bench.panel.start() == Status::kOk);
  const Scene<TestType> scene(bench.panel);
  REQUIRE(send_whole(bench, scene.frame) == Status::kOk);
  const sim::Picture upright = bench.device.picture();

  REQUIRE(bench.panel.set({.inverted = true, .brightness = 90}) == Status::kOk);
  sim::Picture complement = upright;
  for (Rgb8& c : complement.pixels) {
    c = {static_cast<std::uint8_t>(255 - c.r), static_cast<std::uint8_t>(255 - c.g),
         static_cast<std::uint8_t>(255 - c.b)};
  }
  CHECK(bench.device.picture() == complement);
  CHECK((bench.device.brightness() == 90 || bench.device.brightness() == 45));  // 8 bits or 7

  REQUIRE(bench.panel.sleep() == Status::kOk);
  CHECK(black(bench.device.picture()));
  CHECK(send_whole(bench, scene.frame) == Status::kNotReady);
  REQUIRE(bench.panel.set({}) == Status::kOk);
  CHECK(black(bench.device.picture()));
  REQUIRE(bench.panel.wake() == Status::kOk);
  CHECK(bench.device.picture() == upright);
  REQUIRE(bench.panel.wake() == Status::kOk);
  REQUIRE(bench.panel.sleep() == Status::kOk);
  REQUIRE(bench.panel.sleep() == Status::kOk);
  REQUIRE(bench.panel.start() == Status::kOk);
  CHECK(bench.device.picture() == upright);
  CHECK(complaints(bench) == "");
}

TEMPLATE_TEST_CASE("invalid arguments are refused and nothing is sent", "", ARCSPAN_EVERY_PANEL) {
  TestType bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  const std::uint64_t bytes = bench.bus.count().bytes;
  CHECK(bench.panel.set({.orientation = static_cast<Orientation>(4)}) == Status::kInvalidArgument);
  CHECK(bench.panel.set({.transfer_limit_us = 0}) == Status::kInvalidArgument);
  const std::int32_t w = bench.panel.width();
  const std::int32_t h = bench.panel.height();
  const std::vector<std::uint8_t> wire(1000000);
  for (const Rect& area : {Rect{-8, 0, 8, 8}, Rect{0, -8, 8, 8}, Rect{0, 0, w + 8, 8}, Rect{0, 0, 8, h + 8},
                           Rect{8, 8, 8, 16}, Rect{8, 8, 0, 16}, Rect{INT32_MIN, 0, INT32_MAX, 8}}) {
    CHECK(bench.panel.start_write(area, std::span(wire).first(TestType::Driver::Layout::bytes(
                                            {0, 0, 8, 8}))) == Status::kInvalidArgument);
  }
  CHECK(bench.panel.start_write({0, 0, 8, 8}, std::span(wire).first(3)) == Status::kInvalidArgument);
  CHECK(bench.panel.start_write({0, 0, 8, 8}, {}) == Status::kInvalidArgument);
  CHECK(bench.bus.count().bytes == bytes);
  const Glass wide{500, 64, 0, 0, false, false, false, false};
  TestType wrong({}, wide);
  CHECK(wrong.panel.start() == Status::kInvalidArgument);
  CHECK(wrong.bus.count().bytes == 0);
}

TEMPLATE_TEST_CASE("a panel whose reset line does nothing starts from any state", "", ARCSPAN_EVERY_PANEL) {
  TestType bench(PanelSettings{.orientation = Orientation::k180, .inverted = true});
  bench.lose_reset();
  REQUIRE(bench.panel.start() == Status::kOk);
  REQUIRE(bench.panel.set({}) == Status::kOk);
  REQUIRE(bench.panel.start() == Status::kOk);
  const Scene<TestType> scene(bench.panel);
  REQUIRE(send_whole(bench, scene.frame) == Status::kOk);
  CHECK(bench.device.picture() == expected(scene.frame, Orientation::k0));
  // A controller that lost its supply is back after start().
  bench.device.brown_out(bench.clock.now_ns());
  CHECK(black(bench.device.picture()));
  REQUIRE(bench.panel.start() == Status::kOk);
  REQUIRE(send_whole(bench, scene.frame) == Status::kOk);
  CHECK(bench.device.picture() == expected(scene.frame, Orientation::k0));
  CHECK(complaints(bench) == "");
}
