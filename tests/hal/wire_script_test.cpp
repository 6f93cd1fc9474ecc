// SPDX-License-Identifier: MIT
#include <arcspan/hal/sim/wire_script.hpp>

#include <catch2/catch.hpp>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::sim;
using Kind = WireEvent::Kind;

TEST_CASE("a script is read line by line") {
  const WireScript script = parse_wire_script(
      "# the beginning of a driver\n"
      "reset low\n\n"
      "wait 20 us\t# at least 10\n"
      "  command 2A\r\n"
      "data 00 0 ef\n"
      "data f8 00 x3\n"
      "i2c 3c 00 ae = transfer failed\n"
      "read busy high\n"
      "wait 5 ms");
  REQUIRE(script.error == "");
  REQUIRE(script.events.size() == 8);
  CHECK((script.events[0].kind == Kind::kSet && script.events[0].pin == "reset"));
  CHECK(script.events[0].level == Level::kLow);
  CHECK((script.events[1].kind == Kind::kDelay && script.events[1].us == 20));
  CHECK((script.events[2].kind == Kind::kSpi && script.events[2].level == Level::kLow));
  CHECK(script.events[2].bytes == std::vector<std::uint8_t>{0x2A});
  CHECK(script.events[2].line == 5);
  CHECK(script.events[3].level == Level::kHigh);
  CHECK(script.events[3].bytes == std::vector<std::uint8_t>{0x00, 0x00, 0xEF});
  CHECK(script.events[4].bytes == std::vector<std::uint8_t>{0xF8, 0, 0xF8, 0, 0xF8, 0});
  CHECK((script.events[5].kind == Kind::kI2c && script.events[5].address == 0x3C));
  CHECK(script.events[5].bytes == std::vector<std::uint8_t>{0x00, 0xAE});
  CHECK(script.events[5].answer == Status::kTransferFailed);
  CHECK((script.events[6].kind == Kind::kRead && script.events[6].pin == "busy"));
  CHECK(script.events[7].us == 5000);
}

TEST_CASE("a malformed script is refused with the number of its line") {
  const struct {
    const char* text;
    const char* error;
  } cases[] = {
      {"command", "line 1: no bytes"},
      {"\ndata 100", "line 2: not a byte: '100'"},
      {"data -1", "line 1: not a byte: '-1'"},
      {"data 1g", "line 1: not a byte: '1g'"},
      {"data x4", "line 1: no bytes"},
      {"data 1 x0", "line 1: not a number of times: 'x0'"},
      {"data 1 2 x16777216", "line 1: too many bytes"},
      {"data 1 x99999999999999999999", "line 1: not a number of times: 'x99999999999999999999'"},
      {"i2c", "line 1: no address of 7 bits"},
      {"i2c 80 1", "line 1: no address of 7 bits"},
      {"i2c 3c", "line 1: no bytes"},
      {"wait 5", "line 1: expected: wait NUMBER us|ms"},
      {"wait 0 us", "line 1: expected: wait NUMBER us|ms"},
      {"wait 5 s", "line 1: expected: wait NUMBER us|ms"},
      {"wait 1 us = timeout", "line 1: a delay cannot fail"},
      {"data 1 = broken", "line 1: not a status: 'broken'"},
      {"= timeout", "line 1: nothing before ="},
      {"reset", "line 1: expected: command, data, i2c, wait, read PIN low|high or PIN low|high"},
      {"read busy", "line 1: expected: command, data, i2c, wait, read PIN low|high or PIN low|high"},
  };
  for (const auto& wrong : cases) CHECK(parse_wire_script(wrong.text).error == wrong.error);
  const WireScript script = parse_wire_script("reset low\nreset\nreset high");
  CHECK(script.events.size() == 1);
}

TEST_CASE("a written script reads back as the same") {
  std::vector<WireEvent> events = parse_wire_script(
                                      "reset low\nwait 3 us\nreset high\nwait 120 ms\ncommand 2a = timeout\n"
                                      "data 01 02 03 04 f8 00 x400\nread busy low\ni2c 3c 00 x40\ndata 7 x3")
                                      .events;
  // Long and without runs: over several lines.
  for (int i = 0; i < 100; ++i) events.back().bytes.push_back(static_cast<std::uint8_t>(i * 37));
  const std::string script = to_script(events);
  CAPTURE(script);
  const WireScript again = parse_wire_script(script);
  REQUIRE(again.error == "");
  // Bytes may have been cut; joined they are the same.
  const auto flat = [](const std::vector<WireEvent>& list) {
    std::string all;
    for (const WireEvent& e : list) {
      all += std::to_string(static_cast<int>(e.kind)) + e.pin + std::to_string(e.us) +
             arcspan::to_string(e.answer);
      all += e.level == Level::kHigh ? 'h' : 'l';
      for (const int byte : e.bytes) all += std::to_string(byte) + ",";
    }
    return all;
  };
  std::vector<WireEvent> joined;
  for (const WireEvent& e : again.events) {
    const bool goes_on = !joined.empty() && e.kind == Kind::kSpi && joined.back().kind == Kind::kSpi &&
                         joined.back().level == e.level && ok(joined.back().answer);
    if (!goes_on) {
      joined.push_back(e);
    } else {
      joined.back().bytes.insert(joined.back().bytes.end(), e.bytes.begin(), e.bytes.end());
    }
  }
  // The events' own D/C bytes that follow each other: `data` after `i2c` stays apart.
  CHECK(flat(joined) == flat(events));
}

TEST_CASE("runs of bytes and of pixels are counted") {
  WireEvent event;
  event.kind = Kind::kSpi;
  event.level = Level::kHigh;
  event.bytes = {1, 2};
  for (int i = 0; i < 240; ++i) event.bytes.insert(event.bytes.end(), {0xF8, 0x1F});
  for (int i = 0; i < 9; ++i) event.bytes.push_back(0);
  CHECK(to_script({event}) == "data 01 02\ndata f8 1f x240\ndata 00 x9\n");
  CHECK(to_string(event) == "data 01 02 ... (491 bytes)");
}
