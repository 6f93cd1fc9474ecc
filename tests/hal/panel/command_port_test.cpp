// SPDX-License-Identifier: MIT
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/mipi_dcs.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace arcspan;
using namespace arcspan::hal;

namespace {

/// A wire log like "C 2a D 00 05": bytes by the level of D/C. The n-th operation (pin or bus) can fail.
class Wire final : public SpiBus, public OutputPin {
 public:
  std::string log;
  int fail_at = -1;
  int operations = 0;

 private:
  Status do_set(Level level) override {
    if (operations++ == fail_at) return Status::kTransferFailed;
    log += level == Level::kLow ? "C " : "D ";
    return Status::kOk;
  }
  Status do_write(std::span<const std::uint8_t> bytes) override {
    if (operations++ == fail_at) return Status::kTransferShort;
    for (const int byte : bytes) {
      log += "0123456789abcdef"[byte >> 4];
      log += "0123456789abcdef"[byte & 15];
      log += ' ';
    }
    return Status::kOk;
  }
};

std::string sent(const dcs::Command& command) {
  Wire wire;
  CommandPort port(wire, wire);
  CHECK(ok(port.command(command.opcode, command.parameters())));
  return wire.log;
}

}  // namespace

TEST_CASE("DCS commands are these bytes, parameters with D/C high") {
  CHECK(sent(dcs::kSoftwareReset) == "C 01 ");
  CHECK(sent(dcs::kSleepIn) == "C 10 ");
  CHECK(sent(dcs::kSleepOut) == "C 11 ");
  CHECK(sent(dcs::inversion(false)) == "C 20 ");
  CHECK(sent(dcs::inversion(true)) == "C 21 ");
  CHECK(sent(dcs::kDisplayOff) == "C 28 ");
  CHECK(sent(dcs::kDisplayOn) == "C 29 ");
  CHECK(sent(dcs::columns(0x0102, 0xFF3F)) == "C 2a D 01 02 ff 3f ");
  CHECK(sent(dcs::rows(0, 319)) == "C 2b D 00 00 01 3f ");
  CHECK(sent(dcs::kMemoryWrite) == "C 2c ");
  CHECK(sent(dcs::kPixelFormatRgb565) == "C 3a D 55 ");
  CHECK(sent(dcs::brightness(200)) == "C 51 D c8 ");
}

TEST_CASE("each flag of the address mode is its own bit") {
  CHECK(sent(dcs::address_mode({})) == "C 36 D 00 ");
  CHECK(sent(dcs::address_mode({.mirror_rows = true})) == "C 36 D 80 ");
  CHECK(sent(dcs::address_mode({.mirror_columns = true})) == "C 36 D 40 ");
  CHECK(sent(dcs::address_mode({.swap_axes = true})) == "C 36 D 20 ");
  CHECK(sent(dcs::address_mode({.blue_first = true})) == "C 36 D 08 ");
}

TEST_CASE("a failure at any step of a command ends it there, and the next command is whole") {
  const dcs::Command command = dcs::rows(1, 2);
  const std::string whole = "C 2b D 00 01 00 02 ";
  const std::string until[] = {"", "C ", "C 2b ", "C 2b D "};
  for (int step = 0; step < 4; ++step) {
    Wire wire;
    CommandPort port(wire, wire);
    wire.fail_at = step;
    CHECK(port.command(command.opcode, command.parameters()) ==
          (step % 2 == 0 ? Status::kTransferFailed : Status::kTransferShort));
    CHECK(wire.log == until[step]);
    CHECK(wire.operations == step + 1);
    wire.log.clear();
    CHECK(port.command(command.opcode, command.parameters()) == Status::kOk);
    CHECK(wire.log == whole);
  }
}

TEST_CASE("D/C does not change while pixels are on the wire") {
  Wire wire;
  CommandPort port(wire, wire);
  const std::uint8_t pixels[] = {0xAB, 0xCD};
  REQUIRE(port.start_data(pixels) == Status::kOk);
  CHECK(port.command(dcs::kMemoryWrite.opcode) == Status::kBusy);
  CHECK(port.data(pixels) == Status::kBusy);
  CHECK(port.start_data(pixels) == Status::kBusy);
  CHECK(wire.log == "D ab cd ");
  CHECK(port.bus().poll() == Status::kOk);
  CHECK(port.data(pixels) == Status::kOk);
  CHECK(wire.log == "D ab cd D ab cd ");
}
