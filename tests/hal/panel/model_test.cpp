// SPDX-License-Identifier: MIT
// What the simulated devices refuse: each breach of a datasheet is complained about, so that the drivers'
// tests, which allow no complaint, prove something.
#include "benches.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace arcspan;
using namespace arcspan::hal;
using namespace arcspan::hal::bench;

namespace {

/// Bytes by hand: "c" sends commands, "d" data; `all` joins what was complained about.
template <class Model>
struct Hand {
  explicit Hand(const Glass& glass) : device(glass) {}
  Model device;
  std::uint64_t now = 1'000'000'000;
  void c(std::initializer_list<int> bytes) { send(bytes, Level::kLow); }
  void d(std::initializer_list<int> bytes) { send(bytes, Level::kHigh); }
  void send(std::initializer_list<int> bytes, Level level) {
    for (const int byte : bytes) device.receive(static_cast<std::uint8_t>(byte), level, now += 1000);
  }
  void wait_ms(std::uint64_t ms) { now += ms * 1'000'000; }
  bool complains(const std::string& about) {
    bool found = false;
    for (const std::string& line : device.complaints())
      found = found || line.find(about) != std::string::npos;
    device.forget_complaints();
    return found;
  }
};

struct Dcs : Hand<sim::DcsModel> {
  Dcs() : Hand(kIli9341Module) {
    c({0x11});
    wait_ms(120);
    c({0x3A});
    d({0x55});
    c({0x29});
  }
};

}  // namespace

TEST_CASE("the DCS model complains about everything that the datasheet forbids") {
  Dcs h;
  REQUIRE(h.device.complaints().empty());
  SECTION("data before a memory write") {
    h.d({1});
    CHECK(h.complains("before a memory write"));
  }
  SECTION("a command cut short") {
    h.c({0x2A});
    h.d({0, 0, 0});
    h.c({0x2C});
    CHECK(h.complains("was cut short"));
  }
  SECTION("a pixel cut in half") {
    h.c({0x2C});
    h.d({1});
    h.c({0x29});
    CHECK(h.complains("cut in half"));
  }
  SECTION("a window that ends before it begins, or outside the memory") {
    h.c({0x2A});
    h.d({0, 9, 0, 8});
    h.c({0x2C});
    CHECK(h.complains("bad column window"));
    h.c({0x2A});
    h.d({0, 0, 0, 240});
    h.c({0x2C});
    CHECK(h.complains("bad column window"));
    h.c({0x2B});
    h.d({0, 0, 1, 64});
    h.c({0x2C});
    CHECK(h.complains("bad row window"));
  }
  SECTION("more pixels than the window holds, which wrap") {
    h.c({0x2A});
    h.d({0, 0, 0, 1});
    h.c({0x2B});
    h.d({0, 0, 0, 0});
    h.c({0x2C});
    h.d({0xFF, 0xFF, 0, 0});
    CHECK_FALSE(h.complains("more pixels"));
    h.d({0xF8, 0x00});
    CHECK(h.complains("more pixels"));
    CHECK(h.device.picture().at(239, 0) == Rgb8{0, 0, 255});  // mirrored columns, and blue first without BGR
  }
  SECTION("pixels in another format, or in sleep") {
    h.c({0x3A});
    h.d({0x66});
    h.c({0x2C});
    CHECK(h.complains("not 16 bits"));
    h.c({0x10});
    h.wait_ms(5);
    h.c({0x2C});
    CHECK(h.complains("sleep mode"));
  }
  SECTION("sleep and reset too soon one after the other") {
    h.c({0x10});
    h.c({0x28});
    CHECK(h.complains("less than 5 ms"));
    h.wait_ms(10);
    h.c({0x11});
    CHECK(h.complains("less than 120 ms"));
    h.wait_ms(120);
    h.c({0x01});
    h.wait_ms(6);
    h.c({0x11});  // 120 ms after a reset out of sleep
    CHECK(h.complains("less than 120 ms"));
  }
  SECTION("a reset that is too short does nothing, one that is long enough deafens for 5 ms") {
    h.device.reset_line(Level::kLow, h.now);
    h.device.reset_line(Level::kHigh, h.now += 9'000);
    CHECK(h.complains("only 9000 ns"));
    CHECK(h.device.awake());
    h.device.reset_line(Level::kLow, h.now);
    h.c({0x00});
    CHECK(h.complains("while reset is low"));
    h.device.reset_line(Level::kHigh, h.now += 10'000);
    CHECK_FALSE(h.device.awake());
    h.c({0x00});
    CHECK(h.complains("too soon after reset"));
  }
  SECTION("a reset out of sleep, long after the last command") {
    h.c({0x51});
    h.d({9});
    CHECK(h.device.brightness() == 9);
    h.wait_ms(1000);
    h.device.reset_line(Level::kLow, h.now);
    h.device.reset_line(Level::kHigh, h.now += 10'000);
    CHECK(h.device.brightness() == 0);
    h.wait_ms(6);
    h.c({0x11});
    CHECK(h.complains("less than 120 ms"));
  }
  SECTION("what is no command") {
    h.c({0xCC});
    CHECK(h.complains("unknown command 0xcc"));
  }
}

TEST_CASE("the SSD1306 model takes parameters as commands") {
  Hand<sim::Ssd1306Model> h(kSsd1306Module);
  h.c({0xAF});
  h.d({1});
  CHECK(h.complains("before a window"));
  h.c({0x21, 5});
  h.d({1});
  CHECK(h.complains("amid command 0x21"));
  h.c({4});
  CHECK(h.complains("bad columns"));
  h.c({0x21, 0, 0, 0x22, 0, 0});
  h.d({1});
  CHECK_FALSE(h.complains(""));
  h.d({1});
  CHECK(h.complains("more pixels"));
  h.c({0xAE});
  h.d({1});
  CHECK(h.complains("display is off"));
}

TEST_CASE("the SSD0323 model knows its rows, its display lines and its reset") {
  Hand<sim::Ssd0323Model> h({128, 80, 0, 0, false, false, false, false});
  h.c({0xAF, 0xA8, 0x3F, 0x15, 0, 0x40});
  CHECK(h.complains("bad columns 0x00 to 0x40"));
  h.c({0x75, 9, 8});
  CHECK(h.complains("bad rows 0x09 to 0x08"));
  h.c({0x15, 0, 0, 0x75, 0, 0});
  h.d({0x0F});
  CHECK_FALSE(h.complains(""));
  CHECK(h.device.picture().at(0, 0) == Rgb8{255, 255, 255});  // the low nibble, without re-map
  CHECK(h.device.picture().at(1, 0) == Rgb8{});
  CHECK(h.device.picture().at(0, 64) == Rgb8{});  // 64 lines
  h.d({0});
  CHECK(h.complains("more pixels"));
  h.c({0x75, 1, 1, 0x15, 0, 0});  // in either order
  h.d({0x0F});
  CHECK(h.device.picture().at(0, 0) == Rgb8{});
  CHECK(h.device.picture().at(0, 1) == Rgb8{255, 255, 255});
  h.c({0xA1, 1});  // moves the memory, not the lines
  CHECK(h.device.picture().at(0, 0) == Rgb8{255, 255, 255});
  CHECK(h.device.picture().at(0, 79) == Rgb8{});
  h.c({0xA1, 0});
  h.c({0x15, 0, 0, 0x75, 0, 0});
  h.d({0xF0});
  h.c({0xA0, 0x52, 0xA2, 0x40});  // COMs from 79 down, of which the first of 64 lines is 63
  CHECK(h.device.picture().at(0, 63) == Rgb8{255, 255, 255});
  const sim::Picture moved = h.device.picture();
  for (std::int32_t x = 0; x < 128; ++x) CHECK(moved.at(x, 79) == Rgb8{});  // still 64 lines
  h.c({0xCC});
  CHECK(h.complains("unknown command 0xcc"));
  h.device.reset_line(Level::kLow, h.now);
  h.device.reset_line(Level::kHigh, h.now += 2'000);
  CHECK(h.complains("only 2000 ns"));
  h.device.reset_line(Level::kLow, h.now);
  h.device.reset_line(Level::kHigh, h.now += 3'000);
  CHECK(h.device.brightness() == 0x40);
  h.c({0xE3});
  CHECK(h.complains("too soon after reset"));
}

TEST_CASE("SSD0323: a glass that begins or ends within a byte is refused") {
  for (const Glass& glass : {Glass{127, 64}, Glass{126, 64, 1}})
    CHECK(Ssd0323Bench({}, glass).panel.start() == Status::kInvalidArgument);
}

TEST_CASE("the SSD1351 model keeps its locks") {
  Hand<sim::Ssd1351Model> h(kSsd1351Module);
  h.c({0xA2});
  h.d({0});
  CHECK(h.complains("is locked"));
  h.c({0xFD});
  h.d({0xB1});
  h.c({0xA2});
  h.d({0});
  CHECK_FALSE(h.complains(""));
  h.c({0xFD});
  h.d({0x16});
  h.c({0xAF});
  CHECK(h.complains("while commands are locked"));
  h.c({0xFD});
  h.d({0x12});
  h.c({0xA0});
  h.d({0xA0});
  h.c({0x5C});
  CHECK(h.complains("not 65k colours"));
  h.c({0x15});
  h.c({0x5C});
  CHECK(h.complains("was cut short"));
}

TEST_CASE("the SSD1351 model takes a window in either order") {
  Hand<sim::Ssd1351Model> h(kSsd1351Module);
  const auto send = [&h](int command, std::initializer_list<int> bytes) {
    h.c({command});
    h.d(bytes);
  };
  send(0xFD, {0x12});
  h.c({0xAF});
  send(0xA0, {0x60});
  std::vector<sim::Picture> pictures;
  for (const int byte : {0xFF, 0}) {
    if (byte == 0) send(0x15, {3, 3});
    send(0x75, {5, 5});
    if (byte != 0) send(0x15, {3, 3});
    send(0x5C, {byte, byte});
    pictures.push_back(h.device.picture());
  }
  int different = 0;
  for (std::size_t i = 0; i < pictures[0].pixels.size(); ++i)
    different += pictures[0].pixels[i] == Rgb8{255, 255, 255} && pictures[1].pixels[i] == Rgb8{} ? 1 : 0;
  CHECK(different == 1);
  CHECK_FALSE(h.complains(""));
}

TEST_CASE("what arrives of a transfer that is given up, or has a fault, is what was sent until then") {
  const std::array<std::uint8_t, 8> bytes{};
  sim::SimulatedClock clock;
  sim::Ssd1306Model device(kSsd1306Module);
  clock.advance_ns(10'000'000);
  sim::SimulatedSpi spi(device, clock, 100'000);
  REQUIRE(spi.start(bytes) == Status::kOk);
  CHECK(spi.wait(clock, 250) == Status::kTimeout);
  CHECK(spi.count().bytes == 3);
  sim::SimulatedI2c i2c(device, 0x3C, clock, 400'000);
  i2c.inject({sim::Fault::Kind::kFailed, 3});
  CHECK(i2c.write(0x3C, bytes) == Status::kTransferFailed);
  CHECK(i2c.count().bytes == 4);  // and the address
}

TEST_CASE("setting says what became of the transfer before it, and sends nothing after a failed one") {
  Ssd1351Bench bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  bench.bus.inject({sim::Fault::Kind::kFailed, 15});
  const std::array<std::uint8_t, 128> wire{};
  REQUIRE(bench.panel.start_write({0, 0, 8, 8}, wire) == Status::kOk);
  CHECK(bench.panel.set({.brightness = 7}) == Status::kTransferFailed);
  CHECK(bench.device.brightness() != 7);
  CHECK(bench.panel.needs_configuration());
  CHECK(bench.panel.set({.brightness = 7}) == Status::kOk);
  CHECK(bench.device.brightness() == 7);
  CHECK_FALSE(bench.panel.needs_configuration());  // all of it has just been sent
}

TEST_CASE("the simulated bus complains if bytes or D/C change under a transfer") {
  Ssd1306Bench bench;
  REQUIRE(bench.panel.start() == Status::kOk);
  std::uint8_t wire[8] = {};
  REQUIRE(bench.panel.start_write({0, 0, 8, 8}, wire) == Status::kOk);
  wire[3] = 1;
  REQUIRE(bench.bus.dc.set(Level::kLow) == Status::kOk);
  CHECK(bench.panel.finish() == Status::kOk);
  CHECK(bench.bus.complaints().size() == 2);
}
