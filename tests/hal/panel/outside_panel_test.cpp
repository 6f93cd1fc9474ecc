// SPDX-License-Identifier: MIT
// A panel and its wire layout that the library does not know: nothing but public headers is needed.
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/sim/simulated_bus.hpp>
#include <arcspan/pixel/gray8.hpp>

#include <catch2/catch.hpp>

#include <vector>

using namespace arcspan;
using namespace arcspan::hal;

namespace {

/// 8-bit grey, rows as they are.
struct GreyRows {
  using Format = Gray8;
  static constexpr std::int32_t column_step(Orientation) { return 1; }
  static constexpr std::int32_t row_step(Orientation) { return 1; }
  static constexpr std::size_t bytes(const Rect& area) {
    return static_cast<std::size_t>(area.width()) * static_cast<std::size_t>(area.height());
  }
  static void pack(const Framebuffer<Gray8>& frame, const Rect& area, Orientation, std::uint8_t* out) {
    for (std::int32_t y = area.top; y < area.bottom; ++y) {
      for (std::int32_t x = area.left; x < area.right; ++x) *out++ = frame.row(y)[x];
    }
  }
};

/// Windows of threes of columns.
struct GreyTriples : GreyRows {
  static constexpr std::int32_t column_step(Orientation) { return 3; }
};

/// A made-up controller: 'R' resets, 'W' x y w h opens a window; sleeps on 'S', wakes on 'A'.
template <class Wire>
class LetterPanelWith final : public Panel {
 public:
  using Layout = Wire;
  LetterPanelWith(SpiBus& bus, OutputPin& dc, Clock& clock)
      : Panel({20, 10, 0, 0, false, false, false, false}, {}, clock), bus_(bus), dc_(dc) {}

 private:
  bool do_fits() const override { return true; }
  Status do_reset() override { return letter('R'); }
  Status do_configure() override { return letter('A'); }
  Status do_sleep() override { return letter('S'); }
  Status do_wake() override { return letter('A'); }
  bool do_takes(const Rect& area, std::size_t bytes) const override { return bytes == GreyRows::bytes(area); }
  Status do_open_window(const Rect& area) override {
    const std::uint8_t bytes[] = {
        'W', static_cast<std::uint8_t>(area.left), static_cast<std::uint8_t>(area.top),
        static_cast<std::uint8_t>(area.width()), static_cast<std::uint8_t>(area.height())};
    const Status status = dc_.set(Level::kLow);
    return ok(status) ? bus_.write(bytes) : status;
  }
  Status do_start_pixels(std::span<const std::uint8_t> wire) override {
    const Status status = dc_.set(Level::kHigh);
    return ok(status) ? bus_.start(wire) : status;
  }
  Status do_wait(std::uint32_t limit_us) override { return bus_.wait(clock(), limit_us); }

  Status letter(char c) {
    const auto byte = static_cast<std::uint8_t>(c);
    const Status status = dc_.set(Level::kLow);
    return ok(status) ? bus_.write({&byte, 1}) : status;
  }

  SpiBus& bus_;
  OutputPin& dc_;
};

/// The device at the other end, in the test as well.
class LetterDevice final : public sim::DisplayModel {
 public:
  LetterDevice() : DisplayModel({20, 10, 0, 0, false, false, false, false}), memory_(200) {}

 private:
  void do_command(std::uint8_t byte) override {
    if (window_.size() % 5 != 0) return window_.push_back(byte);
    if (byte == 'W') window_.assign(1, byte);
    if (byte == 'R') memory_.assign(200, 0);
    awake_ = byte == 'S' ? false : byte == 'A' ? true : awake_;
    next_ = 0;
  }
  void do_data(std::uint8_t byte) override {
    if (window_.size() != 5) return complain("data before a window");
    const int x = window_[1] + next_ % window_[3];
    const int y = window_[2] + next_ / window_[3];
    ++next_;
    memory_[static_cast<std::size_t>(y * 20 + x)] = byte;
  }
  void do_reset() override {}
  void do_scramble() override {}
  bool do_lit() const override { return awake_; }
  Rgb8 do_pixel(int column, int row) const override {
    return Gray8::decode(memory_[static_cast<std::size_t>(row * 20 + column)]);
  }
  std::uint64_t do_min_reset_ns() const override { return 0; }
  std::uint64_t do_after_reset_ns() const override { return 0; }

  std::vector<std::uint8_t> memory_;
  std::vector<std::uint8_t> window_;
  int next_ = 0;
  bool awake_ = false;
};

using LetterPanel = LetterPanelWith<GreyRows>;
static_assert(PanelDriver<LetterPanel>);

}  // namespace

TEST_CASE("a panel from outside the library works in page mode") {
  sim::SimulatedClock clock;
  LetterDevice device;
  sim::SimulatedSpi bus(device, clock, 1'000'000);
  LetterPanel panel(bus, bus.dc, clock);
  REQUIRE(panel.start() == Status::kOk);
  std::vector<std::uint8_t> band(20 * 3);
  std::vector<std::uint8_t> wire(20 * 3);
  PageMode<LetterPanel> mode(panel, band, wire, 3);
  REQUIRE(mode.show([](Framebuffer<Gray8>& frame) {
    for (std::int32_t y = frame.bounds().top; y < frame.bounds().bottom; ++y) {
      for (std::int32_t x = 0; x < 20; ++x) frame.row(y)[x] = static_cast<std::uint8_t>(10 * y + x);
    }
    return Status::kOk;
  }) == Status::kOk);
  const sim::Picture shown = device.picture();
  for (std::int32_t y = 0; y < 10; ++y) {
    for (std::int32_t x = 0; x < 20; ++x) REQUIRE(shown.at(x, y).g == 10 * y + x);
  }
  CHECK(device.complaints().empty());
}

TEST_CASE("while a band is on the wire the next one is drawn: the times overlap") {
  sim::SimulatedClock clock;
  LetterDevice device;
  sim::SimulatedSpi bus(device, clock, 1'000'000);  // 8 us a byte
  LetterPanel panel(bus, bus.dc, clock);
  REQUIRE(panel.start() == Status::kOk);
  std::vector<std::uint8_t> band(20 * 2);
  std::vector<std::uint8_t> wire(20 * 2);
  PageMode<LetterPanel> mode(panel, band, wire, 2);
  const std::uint64_t begin = clock.now_ns();
  REQUIRE(mode.show([&clock](Framebuffer<Gray8>& frame) {
    frame.clear({1, 1, 1});
    clock.advance_ns(300'000);
    return Status::kOk;
  }) == Status::kOk);
  // 5 bands: 300 us to draw and 8 * (40 + 5) = 360 us to send each. One after the other it would be 3300 us;
  // overlapped it is one drawing, five sendings, and up to 10 us at a time between two looks.
  const std::uint64_t took = clock.now_ns() - begin;
  CHECK(took >= 300'000 + 5 * 360'000);
  CHECK(took <= 300'000 + 5 * 370'000 + 10'000);
}

TEST_CASE("a glass that is no multiple of the layout's steps is refused") {
  sim::SimulatedClock clock;
  LetterDevice device;
  sim::SimulatedSpi bus(device, clock, 1'000'000);
  LetterPanelWith<GreyTriples> panel(bus, bus.dc, clock);  // 20 columns
  REQUIRE(panel.start() == Status::kOk);
  std::vector<std::uint8_t> band(20 * 10);
  std::vector<std::uint8_t> wire(21 * 10);
  PageMode<LetterPanelWith<GreyTriples>> mode(panel, band, wire, 10);
  const auto draw = [](auto&) { return Status::kOk; };
  CHECK(mode.show(draw) == Status::kInvalidArgument);
  CHECK(mode.show_area({0, 0, 3, 3}, draw) == Status::kInvalidArgument);
  const Framebuffer<Gray8> frame(band, 20, 10);
  CHECK(send_area(panel, frame, {0, 0, 3, 3}, wire) == Status::kInvalidArgument);
}
