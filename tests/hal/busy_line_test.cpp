// SPDX-License-Identifier: MIT
#include "panel/benches.hpp"

#include <arcspan/hal/busy_line_spi.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>

#include <catch2/catch.hpp>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::bench;

namespace {

/// A small ILI9341 behind a busy line.
struct BusyBench {
  using Driver = Ili9341;
  sim::SimulatedClock clock;
  sim::DcsModel device{Glass{24, 16, 100, 30, true, false, true, false}};
  sim::SimulatedSpi bus{device, clock, kHertz};
  BusyLineSpi paced{bus, bus.busy, clock, {Level::kHigh, 1000}};
  Ili9341 panel{paced, bus.dc, &bus.reset, clock, device.glass()};

  Status show(unsigned seed) { return send_whole(*this, Scene<BusyBench>(panel, seed).frame); }
  bool shows(unsigned seed) {
    return device.picture() == expected(Scene<BusyBench>(panel, seed).frame, Orientation::k0);
  }
};

}  // namespace

TEST_CASE("a pin is waited for until it carries the level, fails, or the limit is over") {
  SECTION("at once") {
    sim::MockWires mock("read busy low");
    CHECK(mock.input("busy").wait_for(Level::kLow, mock.clock(), 0) == Status::kOk);
    CHECK(mock.finish() == "");
  }
  SECTION("never") {
    sim::MockWires mock("read busy low\nwait 10 us\nread busy low\nwait 10 us\nread busy low");
    CHECK(mock.input("busy").wait_for(Level::kHigh, mock.clock(), 15) == Status::kTimeout);
    CHECK(mock.finish() == "");
  }
  SECTION("a failure") {
    sim::MockWires mock("read busy high\nwait 10 us\nread busy low = transfer failed");
    CHECK(mock.input("busy").wait_for(Level::kLow, mock.clock(), 100) == Status::kTransferFailed);
    CHECK(mock.finish() == "");
  }
  SECTION("no argument") {
    sim::MockWires mock("");
    CHECK(mock.input("busy").wait_for(static_cast<Level>(2), mock.clock(), 0) == Status::kInvalidArgument);
    CHECK(mock.input("busy").wait_for(Level::kLow, mock.clock(), 0x8000'0000U) == Status::kInvalidArgument);
    CHECK(mock.finish() == "");
  }
}

TEST_CASE("transfers wait for a device that is busy") {
  BusyBench bench;
  bench.bus.busy.set_time_ns(300'000);
  REQUIRE(bench.panel.start() == Status::kOk);
  const std::uint64_t transfers = bench.bus.count().transfers;
  const std::uint64_t begin = bench.clock.now_ns();
  REQUIRE(bench.show(1) == Status::kOk);
  CHECK(bench.shows(1));
  CHECK(complaints(bench) == "");
  CHECK(bench.clock.now_ns() - begin >= (bench.bus.count().transfers - transfers) * 300'000);

  // The control: a driver that does not look at the line sends to a device that is busy.
  Ili9341 hasty(bench.bus, bench.bus.dc, nullptr, bench.clock, bench.device.glass());
  REQUIRE(hasty.start() == Status::kOk);
  CHECK(complaints(bench).find("bytes for a device that is busy") != std::string::npos);
}

TEST_CASE("a busy line that is stuck at any transfer is a timeout, and the next frame is right") {
  // Counts down transfers, and then sticks.
  struct Sticking final : InputPin {
    sim::SimulatedSpi* bus = nullptr;
    int reads_left = 0;
    Status do_read(Level& level) override {
      if (reads_left-- == 0) bus->busy.stick(true);
      return bus->busy.read(level);
    }
  };
  for (const bool starting : {true, false}) {
    for (int at = 0;; ++at) {
      BusyBench bench;
      Sticking pin;
      pin.bus = &bench.bus;
      BusyLineSpi paced(bench.bus, pin, bench.clock, {Level::kHigh, 1000});
      Ili9341 panel(paced, bench.bus.dc, &bench.bus.reset, bench.clock, bench.device.glass());
      const Scene<BusyBench> scene(panel, 3);
      std::vector<std::uint8_t> wire(512);
      pin.reads_left = -1;
      if (!starting) REQUIRE(panel.start() == Status::kOk);
      pin.reads_left = at;
      const std::uint64_t bytes = bench.bus.count().bytes;
      const Status status = starting ? panel.start() : send_area(panel, scene.frame, panel.bounds(), wire);
      if (pin.reads_left >= 0) {
        CHECK(status == Status::kOk);
        CHECK(at > 5);
        break;
      }
      INFO("transfer " << at);
      REQUIRE(status == Status::kTimeout);
      if (at == 0) CHECK(bench.bus.count().bytes == bytes);
      bench.bus.busy.stick(false);
      if (starting) REQUIRE(panel.start() == Status::kOk);
      REQUIRE(send_area(panel, scene.frame, panel.bounds(), wire) == Status::kOk);
      REQUIRE(bench.device.picture() == expected(scene.frame, Orientation::k0));
    }
  }
}

TEST_CASE("a busy line that cannot be read and a transfer that hangs behind it give their status") {
  BusyBench bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  bench.bus.busy.fail_once();
  CHECK(bench.show(1) == Status::kTransferFailed);
  REQUIRE(bench.show(2) == Status::kOk);
  CHECK(bench.shows(2));
  bench.bus.inject({sim::Fault::Kind::kStuck, 20});
  CHECK(bench.show(3) == Status::kTimeout);
  CHECK_FALSE(bench.bus.under_way());
  REQUIRE(bench.show(4) == Status::kOk);
  CHECK(bench.shows(4));
}
