// SPDX-License-Identifier: MIT
// Every fault at every byte of an initialisation and of a frame ends in the status that names it, and the
// next frame is right.
#include "benches.hpp"

#include <catch2/catch.hpp>
#include <tests/support/test_share.hpp>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::bench;
using Kind = sim::Fault::Kind;

namespace {

// Small glasses, so that a frame at every byte is quick; no power of two, and offsets on every side.
struct SmallIli9341 : SpiBench<Ili9341, sim::DcsModel> {
  SmallIli9341() : SpiBench({24, 16, 100, 30, true, false, true, false}) {}
};
struct SmallSsd1351 : SpiBench<Ssd1351, sim::Ssd1351Model> {
  SmallSsd1351() : SpiBench({24, 16, 5, 0, false, true, true, false}) {}
};
struct SmallSsd0323 : SolomonSpiBench<Ssd0323, sim::Ssd0323Model> {
  SmallSsd0323() : SolomonSpiBench({24, 16, 6, 0, false, true, false, false}) {}
};
struct SmallSsd1306 : SolomonSpiBench<Ssd1306, sim::Ssd1306Model> {
  SmallSsd1306() : SolomonSpiBench({72, 16, 28, 0, true, true, false, false}) {}
};
struct SmallSsd1306I2c : Ssd1306I2cBench {
  SmallSsd1306I2c() : Ssd1306I2cBench({}, {72, 16, 28, 0, true, true, false, false}) {}
};

#define ARCSPAN_SMALL_PANELS SmallIli9341, SmallSsd1351, SmallSsd0323, SmallSsd1306, SmallSsd1306I2c

/// Every byte; some of them where ARCSPAN_TEST_SHARE says so.
const auto kStep = static_cast<std::uint64_t>(100 / test::share_of(100));

constexpr Kind kKinds[] = {Kind::kFailed, Kind::kShort, Kind::kStuck};

template <class Bench>
Status show(Bench& bench, unsigned seed) {
  using Mode = PageMode<typename Bench::Driver>;
  std::vector<typename Mode::Frame::Word> band(Mode::Frame::words(bench.panel.width(), 8));
  std::vector<std::uint8_t> wire(wire_bytes<typename Bench::Driver>(bench.panel.width(), 8));
  return Mode(bench.panel, band, wire, 8).show([seed](auto& frame) {
    Scene<Bench>::paint(frame, seed);
    return Status::kOk;
  });
}

/// Whether a parameter was taken for a command or the other way round, in the whole life of the device.
template <class Bench>
bool lost_its_place(const Bench& bench) {
  return complaints(bench).find("unknown command") != std::string::npos;
}

template <class Bench>
bool shows(const Bench& bench, unsigned seed) {
  return bench.device.picture() == expected(Scene<Bench>(bench.panel, seed).frame, Orientation::k0);
}

}  // namespace

TEMPLATE_TEST_CASE("a fault at any byte of a frame is named, and the next frame is right", "",
                   ARCSPAN_SMALL_PANELS) {
  for (const Kind kind : kKinds) {
    for (std::uint64_t at = 0;; at += kStep) {
      TestType bench;
      REQUIRE(bench.panel.start() == Status::kOk);
      REQUIRE(show(bench, 1) == Status::kOk);
      bench.bus.inject({kind, at});
      const Status status = show(bench, 2);
      if (bench.bus.cancel_fault()) {
        CHECK(status == Status::kOk);
        CHECK(at > 100);  // it ran past the frame's last byte
        break;
      }
      INFO("byte " << at << ", fault " << static_cast<int>(kind));
      REQUIRE(status == sim::status_of(kind));
      REQUIRE(show(bench, 3) == Status::kOk);
      REQUIRE(shows(bench, 3));
      REQUIRE_FALSE(lost_its_place(bench));
    }
  }
}

TEMPLATE_TEST_CASE("a fault at any byte of an initialisation is named, and the next start is right", "",
                   ARCSPAN_SMALL_PANELS) {
  for (const bool lost_reset : {false, true}) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t at = 0;; at += kStep) {
        TestType bench;
        if (lost_reset) bench.lose_reset();
        bench.bus.inject({kind, at});
        const Status status = bench.panel.start();
        if (bench.bus.cancel_fault()) {
          CHECK(status == Status::kOk);
          CHECK(at > 10);
          break;
        }
        INFO("byte " << at << ", fault " << static_cast<int>(kind));
        REQUIRE(status == sim::status_of(kind));
        REQUIRE(show(bench, 3) == Status::kNotReady);
        REQUIRE(bench.panel.start() == Status::kOk);
        REQUIRE(show(bench, 3) == Status::kOk);
        REQUIRE(shows(bench, 3));
      }
    }
  }
}

TEMPLATE_TEST_CASE("a fault while sleeping, waking or setting is mended by the next wake", "",
                   ARCSPAN_SMALL_PANELS) {
  for (const Kind kind : kKinds) {
    for (int step = 0; step < 3; ++step) {
      for (std::uint64_t at = 0; at < 60; ++at) {
        TestType bench;
        REQUIRE(bench.panel.start() == Status::kOk);
        if (step == 1) REQUIRE(bench.panel.sleep() == Status::kOk);
        bench.bus.inject({kind, at});
        const Status status = step == 0   ? bench.panel.sleep()
                              : step == 1 ? bench.panel.wake()
                                          : bench.panel.set({.brightness = 7});
        if (bench.bus.cancel_fault()) {
          REQUIRE(status == Status::kOk);
        } else {
          REQUIRE(status == sim::status_of(kind));
        }
        if (step < 2) REQUIRE(bench.panel.wake() == Status::kOk);
        REQUIRE(show(bench, 3) == Status::kOk);
        REQUIRE(shows(bench, 3));
      }
    }
  }
}

TEMPLATE_TEST_CASE("a fault while setting is mended by the next frame, also if nothing has changed in it", "",
                   ARCSPAN_SMALL_PANELS) {
  using Mode = PageMode<typename TestType::Driver>;
  for (const Kind kind : kKinds) {
    for (std::uint64_t at = 0;; ++at) {
      TestType bench;
      REQUIRE(bench.panel.start() == Status::kOk);
      std::vector<typename Mode::Frame::Word> band(Mode::Frame::words(bench.panel.width(), 8));
      std::vector<std::uint8_t> wire(wire_bytes<typename TestType::Driver>(bench.panel.width(), 8));
      std::vector<RowExtent> extents(Damage::extents(bench.panel.height()));
      Damage damage(extents, bench.panel.width(), bench.panel.height());
      Mode mode(bench.panel, band, wire, 8);
      const auto show_black = [&] {
        return mode.show_changes(damage, [](auto& sink, auto&) {
          sink.clear({0, 0, 0});
          return Status::kOk;
        });
      };
      REQUIRE(show_black() == Status::kOk);
      bench.bus.inject({kind, at});
      const Status status = bench.panel.set({.inverted = true});
      if (bench.bus.cancel_fault()) break;
      INFO("byte " << at << ", fault " << static_cast<int>(kind));
      REQUIRE(status == sim::status_of(kind));
      REQUIRE(show_black() == Status::kOk);
      REQUIRE(bench.device.picture().at(0, 0) == Rgb8{255, 255, 255});
      const std::uint64_t bytes = bench.bus.count().bytes;
      REQUIRE(show_black() == Status::kOk);
      REQUIRE(bench.bus.count().bytes == bytes);
    }
  }
}

TEMPLATE_TEST_CASE("a pin that fails at any time is named, and the next try is right", "", SmallIli9341,
                   SmallSsd1351, SmallSsd0323, SmallSsd1306) {
  for (const bool starting : {true, false}) {
    for (auto pin : {&sim::SimulatedSpi::reset, &sim::SimulatedSpi::dc}) {
      for (std::uint64_t at = 0;; ++at) {
        TestType bench;
        if (!starting) REQUIRE(bench.panel.start() == Status::kOk);
        (bench.bus.*pin).fail_at(at);
        const Status status = starting ? bench.panel.start() : show(bench, 1);
        if ((bench.bus.*pin).cancel_fault()) {
          CHECK(status == Status::kOk);
          // Reset is set twice by a start and never by a frame; D/C before every transfer.
          if (pin == &sim::SimulatedSpi::reset) {
            CHECK(at == (starting ? 2 : 0));
          } else {
            CHECK(at >= 2);
          }
          break;
        }
        INFO("set " << at << (starting ? " of a start" : " of a frame"));
        REQUIRE(status == Status::kTransferFailed);
        if (starting) REQUIRE(bench.panel.start() == Status::kOk);
        REQUIRE(show(bench, 2) == Status::kOk);
        REQUIRE(shows(bench, 2));
      }
    }
  }
}
