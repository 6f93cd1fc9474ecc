// SPDX-License-Identifier: MIT
// No datasheet was available. The meaning of the commands, and that re-mapped COMs count down from 79
// whatever the multiplex ratio, come from the drivers of Luminary Micro (osram128x64x4.c) and u8g2
// (u8x8_d_ssd1325.c). For their modules this driver sends the same settings.
#include <arcspan/hal/panel/ssd0323.hpp>

namespace arcspan::hal {
namespace {

/// Re-map (A0h). Without it the low nibble is the left pixel; with nibble re-map the high one is. Mirrored
/// columns exchange left and right again.
constexpr int remap(bool columns, bool rows, bool split) {
  constexpr int kColumnRemap = 0x01;
  constexpr int kNibbleRemap = 0x02;
  constexpr int kComRemap = 0x10;
  constexpr int kComSplit = 0x40;
  return (columns ? kColumnRemap : kNibbleRemap) | (rows ? kComRemap : 0) | (split ? kComSplit : 0);
}

}  // namespace

bool Ssd0323::do_fits() const {
  const Glass& g = glass();
  return g.fits(kColumns, kRows) && g.width % 2 == 0 && g.column_offset % 2 == 0 && g.height >= 16;
}

Status Ssd0323::do_configure() {
  const Glass& g = glass();
  const PanelSettings& s = settings();
  const int map = remap(mirrors_columns(g, s.orientation), mirrors_rows(g, s.orientation), split_coms_);
  // Moves the picture's first row to the glass's first COM, or to its last one if COMs count down.
  const int offset =
      (mirrors_rows(g, s.orientation) ? g.row_offset + g.height : kRows - g.row_offset) % kRows;
  const std::uint8_t bytes[] = {0xA0,
                                byte(map),  // re-map
                                0xA1,
                                0x00,  // start line 0
                                0xA2,
                                byte(offset),  // display offset
                                0xA8,
                                byte(g.height - 1),  // multiplex ratio
                                0x86,                // full current range
                                0x81,
                                byte(s.brightness / 2),                        // contrast, 7 bits
                                byte(s.inverted != g.inverted ? 0xA7 : 0xA4),  // inverse or normal
                                0xAF};                                         // display on
  const Status status = end_command();
  return ok(status) ? send(bytes) : status;
}

bool Ssd0323::do_takes(const Rect& area, std::size_t bytes) const {
  return fits_steps<Layout>(area, settings().orientation) && bytes == Layout::bytes(area);
}

Status Ssd0323::do_open_window(const Rect& area) {
  const Glass& g = glass();
  const Orientation o = settings().orientation;
  const Rect r = to_controller_axes(area, o);
  const std::int32_t margin = mirrors_columns(g, o) ? kColumns - g.width - g.column_offset : g.column_offset;
  const std::uint8_t bytes[] = {
      0x15,        byte((margin + r.left) / 2), byte((margin + r.right) / 2 - 1), 0x75,
      byte(r.top), byte(r.bottom - 1)};
  return send(bytes);
}

}  // namespace arcspan::hal
