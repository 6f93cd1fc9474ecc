// SPDX-License-Identifier: MIT
#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/hal/panel/damage.hpp>
#include <arcspan/pixel/gray4.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/sink_part.hpp>

#include <catch2/catch.hpp>
#include <tests/support/misuse_recorder.hpp>

#include <array>

using namespace arcspan;
using arcspan::test::MisuseRecorder;
using hal::Framebuffer;

TEST_CASE("a framebuffer refuses memory that is too small") {
  std::array<std::uint8_t, 9> memory{};
  CHECK(Framebuffer<Gray4>(memory, 5, 3).status() == Status::kOk);
  CHECK(Framebuffer<Gray4>(memory, 5, 4).status() == Status::kBufferTooSmall);
  CHECK(Framebuffer<Gray4>(memory, -5, 3).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Gray4>(memory, 5, 4).bounds().empty());
}

TEST_CASE("builds with checks report pixels outside of a band, as of a run with x and y exchanged") {
  if (!kIsChecked) return;
  std::array<std::uint16_t, 64> memory{};
  Framebuffer<Rgb565> band(memory, 16, 4, 8);
  MisuseRecorder recorder;
  const auto is_reported = [&recorder] { return !recorder.take().empty(); };
  (void)band.open({9, 3, 13});
  (void)band.pixel(15, 11);
  CHECK_FALSE(is_reported());
  const Span wrong[] = {{3, 9, 1}, {9, 3, 14}, {9, -1, 2}, {7, 0, 1}, {12, 0, 1}, {9, 3, 0}};
  for (const Span& run : wrong) {
    CAPTURE(run.y, run.x, run.count);
    (void)band.open(run);
    CHECK(is_reported());
  }
  // A row before the band's last.
  SinkPart part(band, {0, 8, 16, 11});
  (void)part.open({11, 0, 1});
  CHECK(is_reported());
}

TEST_CASE("a sink refuses damage of another size, and a panel is sent none") {
  std::array<std::uint16_t, 64> memory{};
  Framebuffer<Rgb565> band(memory, 16, 4, 8);
  std::array<hal::RowExtent, hal::Damage::extents(12)> extents{};
  const auto status = [&](std::int32_t width, std::int32_t height) {
    hal::Damage damage(extents, width, height);
    return hal::DamageSink(band, damage).status();
  };
  CHECK(status(16, 12) == Status::kOk);
  CHECK(status(15, 12) == Status::kInvalidArgument);
  CHECK(status(16, 11) == Status::kInvalidArgument);
  for (const std::int32_t size : {-1, 65536}) {
    CHECK(hal::Damage(extents, size, 1).status() == Status::kInvalidArgument);
    CHECK(hal::Damage(extents, 1, size).status() == Status::kInvalidArgument);
  }
  hal::Damage damage(extents, 16, 12);
  CHECK(damage.changed_area(-5, 100) == Rect{0, 0, 16, 12});
  for (int frame = 0; frame < 2; ++frame) damage.begin_frame();
  damage.mark({3, 15, 2});  // not inside the picture
  CHECK(damage.changed_area(0, 12).empty());
  damage.mark({3, 15, 1});
  CHECK(damage.changed_area(0, 12) == Rect{15, 3, 16, 4});
  Framebuffer<Rgb565> broken(memory, 17, 4, 8);
  CHECK(hal::DamageSink(broken, damage).status() == Status::kBufferTooSmall);
}

TEST_CASE("another background is damage, the same one is none") {
  std::array<std::uint16_t, 64> memory{};
  Framebuffer<Rgb565> frame(memory, 16, 4);
  std::array<hal::RowExtent, hal::Damage::extents(4)> extents{};
  hal::Damage damage(extents, 16, 4);
  hal::DamageSink sink(frame, damage);
  const auto is_all_changed = [&](Rgb8 colour) {
    damage.begin_frame();
    sink.clear(colour);
    return !damage.changed_area(0, 4).empty();
  };
  for (int i = 0; i < 3; ++i) (void)is_all_changed({1, 2, 3});
  CHECK_FALSE(is_all_changed({1, 2, 3}));
  CHECK(is_all_changed({200, 2, 3}));
  CHECK(is_all_changed({200, 2, 3}));  // the frame before was the first of this colour
  CHECK_FALSE(is_all_changed({200, 2, 3}));
  CHECK(frame.pixel(15, 3).r > 190);
}

TEST_CASE("a framebuffer's size is checked without overflow") {
  std::array<std::uint16_t, 16> memory{};
  // 65536 * 65536 is 0 in 32 bits, 256 * 256 in 16 bits.
  CHECK(Framebuffer<Rgb565>(memory, 65536, 65536).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Rgb565>(memory, INT32_MAX, 1).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Rgb565>(memory, 0, INT32_MAX).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Rgb565>(memory, 256, 256).status() == Status::kBufferTooSmall);
  CHECK(Framebuffer<Rgb565>(memory, 32767, 32767).status() == Status::kBufferTooSmall);
  CHECK(Framebuffer<Rgb565>(memory, 0, 32767).status() == Status::kOk);
}

TEST_CASE("a band lies between row 0 and row INT32_MAX") {
  std::array<std::uint16_t, 12> memory{};
  CHECK(Framebuffer<Rgb565>(memory, 4, 3, -1).status() == Status::kInvalidArgument);
  CHECK(Framebuffer<Rgb565>(memory, 4, 3, INT32_MAX - 2).status() == Status::kInvalidArgument);
  Framebuffer<Rgb565> band(memory, 4, 3, INT32_MAX - 3);
  CHECK(band.status() == Status::kOk);
  CHECK(band.bounds() == Rect{0, INT32_MAX - 3, 4, INT32_MAX});
  for (const std::int32_t row : {INT32_MAX - 2, INT32_MAX, -1, INT32_MIN}) {
    band.move_to(row);
    CHECK(band.status() == Status::kInvalidArgument);
    CHECK(band.bounds().empty());
    band.clear({255, 255, 255});  // the memory is still its own
  }
  band.move_to(6);
  CHECK(band.status() == Status::kOk);
  CHECK(band.bounds() == Rect{0, 6, 4, 9});
  CHECK(band.pixel(3, 8) == Rgb8{255, 255, 255});
}

TEST_CASE("moving a framebuffer does not mend its lack of memory") {
  std::array<std::uint16_t, 11> memory{};
  Framebuffer<Rgb565> band(memory, 4, 3);
  band.move_to(6);
  band.clear({255, 255, 255});
  CHECK(band.status() == Status::kBufferTooSmall);
  CHECK(band.bounds().empty());
  CHECK(memory == std::array<std::uint16_t, 11>{});
}

TEST_CASE("a band keeps the rows it stands for") {
  std::array<std::uint16_t, 12> memory{};
  Framebuffer<Rgb565> band(memory, 4, 3, 6);
  CHECK(band.bounds() == Rect{0, 6, 4, 9});
  band.clear({255, 0, 0});
  auto cursor = band.open({7, 1, 2});
  cursor.write(Rgb565::encode({0, 255, 0}));
  CHECK(ok(band.close({7, 1, 2})));
  CHECK(band.pixel(1, 7) == Rgb8{0, 255, 0});
  CHECK(band.pixel(2, 7) == Rgb8{255, 0, 0});
  CHECK(memory[5] == 0x07E0);
}
