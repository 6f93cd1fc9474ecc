// SPDX-License-Identifier: MIT
// What goes over the wires of each panel, byte by byte: written from the datasheets' command tables and not
// from the drivers, and with the waits, which the models only know as limits.
#include <arcspan/hal/panel/custom_dcs_panel.hpp>
#include <arcspan/hal/panel/ili9341.hpp>
#include <arcspan/hal/panel/page_mode.hpp>
#include <arcspan/hal/panel/ssd0323.hpp>
#include <arcspan/hal/panel/ssd1306.hpp>
#include <arcspan/hal/panel/ssd1351.hpp>
#include <arcspan/hal/panel/st7789.hpp>
#include <arcspan/hal/sim/mock_wires.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::hal;

namespace {

using sim::MockWires;
using Script = std::string;

/// All pixels of a frame in one colour, except for the first.
template <class Driver>
Status send_dotted(Driver& panel, Rgb8 ground, Rgb8 dot) {
  using Frame = Framebuffer<typename Driver::Layout::Format>;
  std::vector<typename Frame::Word> memory(Frame::words(panel.width(), panel.height()));
  Frame frame(memory, panel.width(), panel.height());
  frame.clear(ground);
  typename Frame::Format::Cursor(frame.row(0), 0).write(Frame::Format::encode(dot));
  // One half holds the frame: one window.
  std::vector<std::uint8_t> wire(2 * wire_bytes<Driver>(panel.width(), panel.height()));
  return send_area(panel, frame, panel.bounds(), wire);
}

const Script kDcsReset =
    "reset low\n"
    "wait 20 us\n"
    "reset high\n"
    "wait 120 ms\n"
    "command 01\n"  // software reset
    "wait 125 ms\n"
    "command 11\n"  // sleep out
    "wait 120 ms\n"
    "command 3a\ndata 55\n";  // 16 bits a pixel

const Script kDcsSleepAndWake =
    "command 28\n"
    "command 10\n"
    "wait 125 ms\n"
    "command 11\n"
    "wait 120 ms\n";

}  // namespace

TEST_CASE("ILI9341: the wires of a start, a frame on its side, and of sleep") {
  const Script settings =
      "command 3a\ndata 55\n"
      "command 36\ndata 28\n"  // axes exchanged, blue first: the glass mirrors columns by itself
      "command 13\n"
      "command 20\n"
      "command 51\ndata ff\n"
      "command 53\ndata 24\n"
      "command 29\n";
  MockWires mock(kDcsReset + settings.substr(settings.find("command 36")) +
                 "command 2a\ndata 00 00 01 3f\n"
                 "command 2b\ndata 00 00 00 ef\n"
                 "command 2c\n"
                 "data f8 00\n"
                 "data 00 1f x76799\n" +
                 kDcsSleepAndWake + settings);
  Ili9341 panel(mock.spi(), mock.data_or_command(), &mock.output("reset"), mock.clock(), kIli9341Module,
                {.orientation = Orientation::k90});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 255}, {255, 0, 0}) == Status::kOk);
  CHECK(panel.sleep() == Status::kOk);
  CHECK(panel.wake() == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE("ST7789: the wires of a glass of 240 x 240 turned by half, at the far end of the memory") {
  MockWires mock(kDcsReset +
                 "command 36\ndata c0\n"  // rows and columns mirrored
                 "command 13\n"
                 "command 21\n"  // an IPS glass shows complements
                 "command 51\ndata 80\n"
                 "command 53\ndata 24\n"
                 "command 29\n"
                 "command 2a\ndata 00 00 00 ef\n"
                 "command 2b\ndata 00 50 01 3f\n"  // rows 80 to 319
                 "command 2c\n"
                 "data ff ff\n"
                 "data 07 e0 x57599\n");
  St7789 panel(mock.spi(), mock.data_or_command(), &mock.output("reset"), mock.clock(),
               {240, 240, 0, 0, false, false, false, true},
               {.orientation = Orientation::k180, .brightness = 128});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 255, 0}, {255, 255, 255}) == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE("a controller's own commands are sent before the settings, and again after a failure") {
  static constexpr std::uint8_t kCommands[] = {0xC0, 2, 0x17, 0x15, 0x35, 1, 0x00, 0xE3, 0};
  const Script settings =
      "command c0\ndata 17 15\n"
      "command 35\ndata 00\n"
      "command e3\n"
      "command 3a\ndata 55\n"
      "command 36\ndata 00\n"
      "command 13\n"
      "command 20\n"
      "command 51\ndata ff\n"
      "command 53\ndata 24\n"
      "command 29\n";
  const Script window =
      "command 2a\ndata 00 00 01 3f\n"
      "command 2b\ndata 00 00 01 df\n"
      "command 2c\n";
  MockWires mock(kDcsReset.substr(0, kDcsReset.find("command 3a")) + settings + window +
                 "data 07 e0 00 00 = transfer short\n" + settings.substr(0, settings.find("command 35")) +
                 "command 35 = transfer failed\n" + settings + window + "data 07 e0\ndata 00 00 x153599\n");
  CustomDcsPanel panel(mock.spi(), mock.data_or_command(), &mock.output("reset"), mock.clock(),
                       {320, 480, kCommands}, {320, 480});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 0}, {0, 255, 0}) == Status::kTransferShort);
  CHECK(send_dotted(panel, {0, 0, 0}, {0, 255, 0}) == Status::kTransferFailed);
  CHECK(send_dotted(panel, {0, 0, 0}, {0, 255, 0}) == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE(
    "a malformed table of commands, and a glass beyond the memory, are refused before anything is sent") {
  using Table = std::vector<std::uint8_t>;
  const auto start = [](const Table& commands, const Glass& glass) {
    MockWires mock("");
    CustomDcsPanel panel(mock.spi(), mock.data_or_command(), nullptr, mock.clock(), {132, 162, commands},
                         glass);
    const Status status = panel.start();
    CHECK(mock.finish() == "");
    return status;
  };
  const Glass small{128, 160, 4, 2};
  const auto commands = GENERATE(Table{0xC0},                              // no number of parameters
                                 Table{0xC0, 2, 0x17},                     // a parameter is missing
                                 Table{0xE3, 0, 0xC0, 255, 1, 2},          // many are
                                 Table{0x01, 0}, Table{0xE3, 0, 0x10, 0},  // reset, sleep in
                                 Table{0x11, 0, 0xE3, 0});                 // sleep out
  CHECK(start(commands, small) == Status::kInvalidArgument);
  CHECK(start({}, {128, 160, 5, 2}) == Status::kInvalidArgument);
  CHECK(start({}, {128, 160, 4, 3}) == Status::kInvalidArgument);
}

TEST_CASE("SSD1351: the wires of a start and a frame") {
  MockWires mock(
      "reset low\nwait 10 us\nreset high\nwait 10 us\n"
      "command fd\ndata 12\n"  // commands unlocked
      "command ae\n"
      "command fd\ndata 12\n"
      "command fd\ndata b1\n"
      "command a0\ndata 74\n"  // 65k colours, COM split, COM re-map, colours swapped
      "command a1\ndata 00\n"
      "command a2\ndata 00\n"
      "command ca\ndata 7f\n"
      "command c1\ndata 40 40 40\n"
      "command c7\ndata 0f\n"
      "command a7\n"  // inverse
      "command af\n"
      "command 15\ndata 00 7f\n"
      "command 75\ndata 00 7f\n"
      "command 5c\n"
      "data f8 00\n"
      "data 00 00 x16383\n"
      "command ae\n");
  Ssd1351 panel(mock.spi(), mock.data_or_command(), &mock.output("reset"), mock.clock(), kSsd1351Module,
                {.inverted = true, .brightness = 64});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 0}, {255, 0, 0}) == Status::kOk);
  CHECK(panel.sleep() == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE("SSD0323: the wires of a start and a frame; parameters are commands") {
  MockWires mock(
      "reset low\nwait 10 us\nreset high\nwait 10 us\n"
      "command e3 e3 ae\n"
      "command e3 e3\n"
      "command a0 52\n"  // COM split and re-map, nibbles exchanged
      "command a1 00\n"
      "command a2 40\n"  // COMs count from 79 down, and the glass has the first 64 of them
      "command a8 3f\n"
      "command 86\n"
      "command 81 7f\n"
      "command a4\n"
      "command af\n"
      "command 15 00 3f\n"
      "command 75 00 3f\n"
      "data f0\n"
      "data 00 x4095\n"
      "command ae\n");
  SolomonSpi port(mock.spi(), mock.data_or_command());
  Ssd0323 panel(port, &mock.output("reset"), mock.clock());
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 0}, {255, 255, 255}) == Status::kOk);
  CHECK(panel.sleep() == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE("SSD0323: re-map and offset are those of other drivers for known modules") {
  struct Module {
    Glass glass;
    Orientation orientation;
    const char* remap;
    const char* offset;
  };
  const Module modules[] = {
      // LM3S6965 evaluation board: OSRAM_INIT_REMAP 52h, OSRAM_INIT_OFFSET 4Ch
      {{128, 64, 0, 12, false, true, false, false}, Orientation::k0, "command a0 52\n", "command a2 4c\n"},
      // u8g2 for Osram's module: 52h and 40h; turned by half 41h and 50h, which is 0 of 80 rows
      {kSsd0323Module, Orientation::k0, "command a0 52\n", "command a2 40\n"},
      {kSsd0323Module, Orientation::k180, "command a0 41\n", "command a2 00\n"},
  };
  for (const Module& m : modules) {
    MockWires mock(Script("command e3 e3 ae e3 e3\n") + m.remap + "command a1 00\n" + m.offset +
                   "command a8 3f 86 81 7f a4 af\n");
    SolomonSpi port(mock.spi(), mock.data_or_command());
    Ssd0323 panel(port, nullptr, mock.clock(), m.glass, {.orientation = m.orientation});
    CHECK(panel.start() == Status::kOk);
    CHECK(mock.finish() == "");
  }
}

TEST_CASE("SSD1306: the transactions of a start and a frame on I2C") {
  // The frame in transactions of 32 bytes behind the control byte; they have no x.
  Script pixels;
  for (int i = 0; i < 128 * 16 / 8; ++i) {
    if (i % 32 == 0) pixels += "\ni2c 3c 40";
    pixels += i == 0 ? " 01" : " 00";
  }
  MockWires mock(
      "i2c 3c 00 e3 e3\n"
      "i2c 3c 00 ae\n"
      "i2c 3c 00 e3 e3\n"
      // Horizontal addressing, line 0, segments and COMs re-mapped, 16 rows, no offset, sequential COMs,
      // contrast, charge pump, no scrolling, memory shown, not inverted, on.
      "i2c 3c 00 20 00 40 a1 c8 a8 0f d3 00 da 02 81 ff 8d 14 2e a4 a6 af\n"
      "i2c 3c 00 21 00 7f 22 00 01" +
      pixels + "\ni2c 3c 00 ae\n");
  SolomonI2c port(mock.i2c(), SolomonI2c::kUsualAddress);
  Ssd1306 panel(port, nullptr, mock.clock(), {128, 16, 0, 0, true, true, false, false}, {},
                {.alternating_coms = false});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 0}, {255, 255, 255}) == Status::kOk);
  CHECK(panel.sleep() == Status::kOk);
  CHECK(mock.finish() == "");
}

TEST_CASE("SSD1306: glass of 72 x 40 pixels, and stripes that begin at another row") {
  const auto start = [](const Glass& glass, const Ssd1306Wiring& wiring, Orientation orientation,
                        const Script& settings) {
    MockWires mock("i2c 3c 00 e3 e3\ni2c 3c 00 ae\ni2c 3c 00 e3 e3\n" + settings);
    SolomonI2c port(mock.i2c(), SolomonI2c::kUsualAddress);
    Ssd1306 panel(port, nullptr, mock.clock(), glass, {.orientation = orientation}, wiring);
    CHECK(panel.start() == Status::kOk);
    return mock.finish();
  };
  CHECK(start(kSsd1306Module72x40, {.internal_reference = true}, Orientation::k0,
              "i2c 3c 00 ad 30\n"
              "i2c 3c 00 20 00 40 a1 c8 a8 27 d3 00 da 12 81 ff 8d 14 2e a4 a6 af\n") == "");
  // Rows 12 to 51, VCC from outside: mirrored, the last row that is scanned is the first of the memory.
  const Glass stripe{72, 40, 30, 12, true, true, false, false};
  CHECK(start(stripe, {.charge_pump = false}, Orientation::k0,
              "i2c 3c 00 20 00 40 a1 c8 a8 33 d3 00 da 12 81 ff 8d 10 2e a4 a6 af\n") == "");
  CHECK(start(stripe, {}, Orientation::k180,
              "i2c 3c 00 20 00 40 a0 c0 a8 33 d3 34 da 12 81 ff 8d 14 2e a4 a6 af\n") == "");
}

TEST_CASE("nothing is sent after a failure, and all settings are sent before the next frame") {
  const Script window = "command 15\ndata 00 17\ncommand 75\ndata 00 0f\ncommand 5c\n";
  const Script settings =
      "command fd\ndata 12\ncommand fd\ndata b1\ncommand a0\ndata 60\ncommand a1\ndata 00\ncommand a2\ndata "
      "00\n"
      "command ca\ndata 0f\ncommand c1\ndata ff ff ff\ncommand c7\ndata 0f\ncommand a6\ncommand af\n";
  const Script frame = "data 00 1f\ndata 00 00 x383\n";
  MockWires mock("command fd\ndata 12\ncommand ae\n" + settings +
                 "command 15\ndata 00 = transfer short\n" +  // amid a parameter
                 settings + window + frame);
  Ssd1351 panel(mock.spi(), mock.data_or_command(), nullptr, mock.clock(),
                {24, 16, 0, 0, false, false, false, false});
  CHECK(panel.start() == Status::kOk);
  CHECK(send_dotted(panel, {0, 0, 0}, {0, 0, 255}) == Status::kTransferShort);
  CHECK(send_dotted(panel, {0, 0, 0}, {0, 0, 255}) == Status::kOk);
  CHECK(mock.finish() == "");
}
