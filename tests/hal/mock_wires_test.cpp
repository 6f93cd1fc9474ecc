// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>
#include <arcspan/hal/sim/wire_recorder.hpp>

#include <catch2/catch.hpp>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::sim;

namespace {

/// A driver in small: a reset, then a command with parameters.
Status play(WireTap& wires, std::uint8_t parameter) {
  OutputPin& reset = wires.output("reset");
  CommandPort port(wires.spi(), wires.data_or_command());
  Status status = reset.set(Level::kLow);
  wires.clock().delay_us(15);
  wires.clock().delay_us(5);
  if (ok(status)) status = reset.set(Level::kHigh);
  const std::uint8_t parameters[] = {0, 0, parameter};
  if (ok(status)) status = port.command(0x2A, parameters);
  return status;
}

constexpr const char* kScript =
    "reset low\n"
    "wait 20 us\n"
    "reset high\n"
    "command 2a\n"
    "data 00 00\n"
    "data ef\n";

}  // namespace

TEST_CASE("calls as in the script are no difference, however transfers and delays are divided") {
  MockWires mock(kScript);
  CHECK(play(mock, 0xEF) == Status::kOk);
  CHECK(mock.difference() == "");
  CHECK(mock.finish() == "");
  CHECK(mock.waited_us() == 20);
}

TEST_CASE("the first difference is reported, and every call fails after it") {
  MockWires mock(kScript);
  CHECK(play(mock, 0xEE) == Status::kTransferFailed);
  CHECK(mock.difference() == "line 6: expected 'data ef', byte 1 (ef), but it was 'data ee'");
  CHECK(mock.output("reset").set(Level::kLow) == Status::kTransferFailed);
  Level level = Level::kHigh;
  CHECK(mock.input("busy").read(level) == Status::kTransferFailed);
  const std::uint8_t byte = 0;
  CHECK(mock.i2c().write(0x3C, {&byte, 1}) == Status::kTransferFailed);
  CHECK(mock.finish() == "line 6: expected 'data ef', byte 1 (ef), but it was 'data ee'");
}

TEST_CASE("each kind of difference has its words") {
  const struct {
    const char* script;
    const char* difference;
  } cases[] = {
      {"", "the script is over, but it was 'reset low'"},
      {"nonsense", "line 1: expected: command, data, i2c, wait, read PIN low|high or PIN low|high"},
      {"backlight low", "line 1: expected 'backlight low', but it was 'reset low'"},
      {"reset high", "line 1: expected 'reset high', but it was 'reset low'"},
      {"reset low\nwait 19 us\nreset high", "line 3: expected 'reset high', but it was 'wait 1 us'"},
      {"reset low\nwait 21 us\nreset high",
       "line 2: expected 'wait 21 us', of which 1 us are left, but it was 'reset high'"},
      {"reset low\nwait 20 us\nreset high\ndata 2a",
       "line 4: expected 'data 2a', byte 1 (2a), but it was 'command 2a'"},
      {"reset low\nwait 20 us\nreset high\ncommand 2a\ndata 0 0 ef 7",
       "line 5: expected 'data 00 00 ef 07', byte 4 (07), but it ended"},
      {"reset low\nwait 20 us\nreset high\ncommand 2a\ndata 0",
       "the script is over, but it was 'data 00 ef'"},
      {"reset low\nwait 20 us\nreset high\ncommand 2a\ni2c 3c 0",
       "line 5: expected 'i2c 3c 00', but it was 'data 00 00 ef'"},
      {"reset low\nwait 20 us\nreset high\ncommand 2a\ndata 0 0 ef\nread busy low",
       "line 6: expected 'read busy low', but it ended"},
  };
  for (const auto& c : cases) {
    MockWires mock(c.script);
    (void)play(mock, 0xEF);
    CHECK(mock.finish() == c.difference);
  }
}

TEST_CASE("a script gives the answers of the wires") {
  SECTION("a pin") {
    MockWires mock("reset low = transfer failed\nwait 20 us");
    CHECK(play(mock, 0) == Status::kTransferFailed);
    CHECK(mock.finish() == "");
  }
  SECTION("D/C") {
    MockWires mock("reset low\nwait 20 us\nreset high\ncommand 2a\ndc high = transfer failed");
    CHECK(play(mock, 0) == Status::kTransferFailed);
    CHECK(mock.finish() == "");
  }
  SECTION("a transfer, after the bytes that the script has of it") {
    MockWires mock("reset low\nwait 20 us\nreset high\ncommand 2a\ndata 0 0 = transfer short");
    CHECK(play(mock, 0) == Status::kTransferShort);
    CHECK(mock.finish() == "");
  }
  SECTION("what an input pin carries") {
    MockWires mock("read busy high\nwait 10 us\nread busy high\nwait 10 us\nread busy low");
    CHECK(mock.input("busy").wait_for(Level::kLow, mock.clock(), 100) == Status::kOk);
    CHECK(mock.finish() == "");
  }
}

TEST_CASE("the clock begins at the given time") {
  MockWires mock("read busy high\nwait 10 us\nread busy high\nwait 10 us\nread busy high");
  mock.set_now_us(UINT32_MAX - 5);
  CHECK(mock.input("busy").wait_for(Level::kLow, mock.clock(), 20) == Status::kTimeout);
  CHECK(mock.clock().now_us() == 14);
  CHECK(mock.finish() == "");
}

TEST_CASE("a recorder writes the script that its run would pass") {
  WireRecorder recorder;
  REQUIRE(play(recorder, 0xEF) == Status::kOk);
  CHECK(recorder.script() == "reset low\nwait 20 us\nreset high\ncommand 2a\ndata 00 00 ef\n");
  MockWires mock(recorder.script());
  CHECK(play(mock, 0xEF) == Status::kOk);
  CHECK(mock.finish() == "");
  recorder.forget();
  CHECK(recorder.events().empty());
}

TEST_CASE("a recorder passes calls on to the attached bus, and writes down the answers") {
  MockWires device("reset low\nwait 20 us\nreset high\ncommand 2a = transfer short\nread busy high");
  WireRecorder recorder;
  recorder.attach(device.spi());
  recorder.attach(device.clock());
  recorder.attach("reset", device.output("reset"));
  recorder.attach("dc", device.data_or_command());
  recorder.attach("busy", device.input("busy"));
  CHECK(play(recorder, 0xEF) == Status::kTransferShort);
  Level level = Level::kLow;
  CHECK(recorder.input("busy").read(level) == Status::kOk);
  CHECK(level == Level::kHigh);
  CHECK(device.finish() == "");
  CHECK(recorder.script() ==
        "reset low\nwait 20 us\nreset high\ncommand 2a = transfer short\nread busy high\n");

  MockWires adapter("i2c 3c 00 ae = transfer failed");
  WireRecorder i2c;
  i2c.attach(adapter.i2c());
  const std::uint8_t bytes[] = {0x00, 0xAE};
  CHECK(i2c.i2c().write(0x3C, bytes) == Status::kTransferFailed);
  CHECK(i2c.script() == "i2c 3c 00 ae = transfer failed\n");
}
