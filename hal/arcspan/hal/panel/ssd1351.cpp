// SPDX-License-Identifier: MIT
// Section numbers refer to the SSD1351 datasheet, rev 1.5.
#include <arcspan/hal/panel/ssd1351.hpp>

#include <array>

namespace arcspan::hal {
namespace {

constexpr std::uint8_t byte(std::int32_t value) { return static_cast<std::uint8_t>(value); }

struct Command {
  std::uint8_t opcode = 0;
  std::uint8_t count = 0;
  std::array<std::uint8_t, 3> bytes{};
};

Status send_all(CommandPort& port, std::span<const Command> commands) {
  for (const Command& c : commands) {
    const Status status = port.command(c.opcode, {c.bytes.data(), c.count});
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace

bool Ssd1351::do_fits() const {
  const Glass& g = glass();
  return g.fits(kColumns, kRows) && g.height >= 16 && g.row_offset == 0;
}

Status Ssd1351::do_reset() {
  // 8.9: reset is low for at least 2 us, and nothing is sent for 2 us after it.
  constexpr std::uint32_t kResetUs = 10;
  if (reset_ != nullptr) {
    Status status = reset_->set(Level::kLow);
    clock().delay_us(kResetUs);
    if (ok(status)) status = reset_->set(Level::kHigh);
    clock().delay_us(kResetUs);
    if (!ok(status)) return status;
  }
  constexpr Command kUnlockAndSleep[] = {{0xFD, 1, {0x12}}, {0xAE}};  // unlock (10.1.23), sleep (10.1.10)
  return send_all(port_, kUnlockAndSleep);
}

Status Ssd1351::do_configure() {
  // Re-map and colour depth (10.1.5).
  constexpr int kVerticalIncrement = 0x01;
  constexpr int kColumnRemap = 0x02;
  constexpr int kColoursSwapped = 0x04;
  constexpr int kComRemap = 0x10;
  constexpr int kComSplit = 0x20;
  constexpr int k65kColours = 0x40;
  const Glass& g = glass();
  const PanelSettings& s = settings();
  const int map = (turned() ? kVerticalIncrement : 0) |
                  (mirrors_columns(g, s.orientation) ? kColumnRemap : 0) |
                  (g.blue_first ? kColoursSwapped : 0) | (mirrors_rows(g, s.orientation) ? kComRemap : 0) |
                  (split_coms_ ? kComSplit : 0) | k65kColours;
  const Command commands[] = {{0xFD, 1, {0x12}},       // unlock the interface
                              {0xFD, 1, {0xB1}},       // unlock A2, B1, B3, BB, BE, C1 (10.1.23)
                              {0xA0, 1, {byte(map)}},  // (10.1.5)
                              {0xA1, 1, {0x00}},       // start line 0 (10.1.6)
                              {0xA2, 1, {0x00}},       // display offset 0; it is 0x60 after reset (10.1.7)
                              {0xCA, 1, {byte(g.height - 1)}},  // multiplex ratio (10.1.22)
                              {0xC1, 3, {s.brightness, s.brightness, s.brightness}},  // contrast (10.1.20)
                              {0xC7, 1, {0x0F}},                                      // undimmed (10.1.21)
                              {byte(s.inverted != g.inverted ? 0xA7 : 0xA6)},         // (10.1.8)
                              {0xAF}};  // sleep mode off (10.1.10)
  return send_all(port_, commands);
}

Status Ssd1351::do_sleep() { return port_.command(0xAE); }

bool Ssd1351::do_takes(const Rect& area, std::size_t bytes) const { return bytes == Layout::bytes(area); }

Status Ssd1351::do_open_window(const Rect& area) {
  const Glass& g = glass();
  const Orientation o = settings().orientation;
  const Rect r = to_controller_axes(area, o);
  const std::int32_t margin = mirrors_columns(g, o) ? kColumns - g.width - g.column_offset : g.column_offset;
  const Command commands[] = {{0x15, 2, {byte(margin + r.left), byte(margin + r.right - 1)}},  // (10.1.1)
                              {0x75, 2, {byte(r.top), byte(r.bottom - 1)}},                    // (10.1.2)
                              {0x5C}};  // write RAM (10.1.3)
  return send_all(port_, commands);
}

}  // namespace arcspan::hal
