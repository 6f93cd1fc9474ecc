// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/gpio/line_name.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/monotonic_clock.hpp>

#include <catch2/catch.hpp>
#include <tests/linux/guest/tests/guest.hpp>

#include <cstdio>

using namespace arcspan;
using namespace arcspan::linux_host;
using namespace arcspan::test;
using hal::Level;

TEST_CASE("the real libgpiod is linked") {
  std::printf("libgpiod %s\n", gpio::version());
  CHECK(std::string(gpio::version()).substr(0, 1) == environment("GUEST_GPIOD"));
}

TEST_CASE("a pin is found by name and by address, and drives its line") {
  const std::string chip = environment("GUEST_CHIP");
  for (const std::string& name : {std::string("RESET"), chip + ":4", "/dev/" + chip + ":4"}) {
    CAPTURE(name);
    for (const Level initial : {Level::kHigh, Level::kLow}) {
      GpioPin pin;
      REQUIRE(ok(pin.request(name, initial)));
      CHECK(pin.is_held());
      CHECK(line_level(4) == (initial == Level::kHigh ? '1' : '0'));
      for (const Level level : {Level::kHigh, Level::kHigh, Level::kLow, Level::kHigh}) {
        CHECK(ok(pin.set(level)));
        CHECK(line_level(4) == (level == Level::kHigh ? '1' : '0'));
      }
    }
  }
}

TEST_CASE("an input gives the level that its wire is pulled to, and is waited for") {
  linux_host::MonotonicClock clock;
  GpioInput busy;
  Level level = Level::kHigh;
  CHECK(busy.read(level) == Status::kNotReady);
  REQUIRE(ok(busy.request("BUSY")));
  for (const bool high : {true, false, true}) {
    pull_line(2, high);
    REQUIRE(busy.read(level) == Status::kOk);
    CHECK(level == (high ? Level::kHigh : Level::kLow));
    CHECK(busy.wait_for(level, clock, 0) == Status::kOk);
  }
  CHECK(busy.wait_for(Level::kLow, clock, 2000) == Status::kTimeout);
  GpioPin other;
  CHECK(other.request("BUSY", Level::kLow).status == Status::kBusy);
  CHECK(busy.request("NOWHERE").status == Status::kIndexOutOfRange);
  CHECK_FALSE(busy.is_held());
  CHECK(ok(other.request("BUSY", Level::kLow)));
}

TEST_CASE("a line that is held is busy for others, and free again after its release") {
  GpioPin pin;
  REQUIRE(ok(pin.request("DC", Level::kLow)));
  GpioPin other;
  const Result taken = other.request("DC", Level::kLow);
  CHECK(taken.status == Status::kBusy);
  CHECK(taken.text() == "the GPIO line cannot be taken: Device or resource busy");
  CHECK_FALSE(other.is_held());
  CHECK(other.set(Level::kHigh) == Status::kNotReady);
  CHECK(pin.set(Level::kHigh) == Status::kOk);
  pin.release();
  CHECK(pin.set(Level::kLow) == Status::kNotReady);
  CHECK(ok(other.request("DC", Level::kLow)));
  // A second request gives up the first line, even if it fails.
  CHECK(other.request("no such", Level::kLow).status == Status::kIndexOutOfRange);
  CHECK(ok(pin.request("DC", Level::kLow)));
}

TEST_CASE("names that lead to no line, or to two, are refused") {
  GpioPin pin;
  const std::string chip = environment("GUEST_CHIP");
  CHECK(pin.request("", Level::kLow).status == Status::kInvalidArgument);
  CHECK(pin.request("NOWHERE", Level::kLow).text() == "no GPIO chip has a line of this name");
  CHECK(pin.request(chip + ":8", Level::kLow).text() == "the GPIO chip has no such line");
  CHECK(pin.request(chip + ":65535", Level::kLow).status == Status::kIndexOutOfRange);
  CHECK(pin.request("gpiochip99:0", Level::kLow).status == Status::kNotReady);
  CHECK(pin.request("TWICE", Level::kLow).status == Status::kInvalidArgument);
  CHECK(ok(pin.request(chip + ":6", Level::kLow)));  // one of the two
}

TEST_CASE("a chip that is unplugged gives an error, and the pin can be released") {
  write_text(gpio_file("plugged"), "1");
  GpioPin pin;
  REQUIRE(ok(pin.request("PLUGGED_OUTPUT", Level::kHigh)));
  GpioInput input;
  REQUIRE(ok(input.request("PLUGGED_INPUT")));
  CHECK(ok(pin.set(Level::kLow)));
  Level level = Level::kHigh;
  CHECK(input.read(level) == Status::kOk);
  write_text(gpio_file("plugged"), "0");
  CHECK(input.read(level) == Status::kTransferFailed);
  CHECK(pin.set(Level::kHigh) == Status::kTransferFailed);
  pin.release();
  CHECK_FALSE(pin.is_held());
}
