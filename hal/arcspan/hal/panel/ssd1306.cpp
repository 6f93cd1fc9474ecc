// SPDX-License-Identifier: MIT
// Section numbers refer to the SSD1306 datasheet, rev 1.1.
#include <arcspan/hal/panel/ssd1306.hpp>

namespace arcspan::hal {

bool Ssd1306::do_fits() const {
  const Glass& g = glass();
  return g.fits(kColumns, kRows) && g.height >= 16 && g.height % 8 == 0;
}

Status Ssd1306::do_configure() {
  const Glass& g = glass();
  const PanelSettings& s = settings();
  // COM row_offset shows the first row of the memory. Mirrored, the last COM that is scanned does (10.1.14),
  // so that nothing has to be offset.
  const bool mirrored = mirrors_rows(g, s.orientation);
  const std::int32_t offset = mirrored || g.row_offset == 0 ? 0 : kRows - g.row_offset;
  const std::uint8_t bytes[] = {
      0x20,
      0x00,                                                      // horizontal addressing (10.1.3)
      0x40,                                                      // start line 0 (10.1.6)
      byte(0xA0 | (mirrors_columns(g, s.orientation) ? 1 : 0)),  // segment re-map (10.1.8)
      byte(0xC0 | (mirrored ? 8 : 0)),                           // COM scan direction (10.1.14)
      0xA8,
      byte(g.row_offset + g.height - 1),  // multiplex ratio (10.1.11)
      0xD3,
      byte(offset),  // display offset (10.1.15)
      0xDA,
      byte(wiring_.alternating_coms ? 0x12 : 0x02),  // COM pins (10.1.18)
      0x81,
      s.brightness,  // contrast (10.1.7)
      0x8D,
      byte(wiring_.charge_pump ? 0x14 : 0x10),       // charge pump (8Dh)
      0x2E,                                          // no scrolling (10.2.3)
      0xA4,                                          // show the memory (10.1.9)
      byte(s.inverted != g.inverted ? 0xA7 : 0xA6),  // (10.1.10)
      0xAF};                                         // display on (10.1.12)
  Status status = end_command();
  if (ok(status) && wiring_.internal_reference) {
    constexpr std::uint8_t kReference[] = {0xAD, 0x30};  // internal, 30 uA (SSD1315 rev 1.1, IREF selection)
    status = send(kReference);
  }
  return ok(status) ? send(bytes) : status;
}

bool Ssd1306::do_takes(const Rect& area, std::size_t bytes) const {
  return fits_steps<Layout>(area, settings().orientation) && bytes == Layout::bytes(area);
}

Status Ssd1306::do_open_window(const Rect& area) {
  const Glass& g = glass();
  const Orientation o = settings().orientation;
  const Rect r = to_controller_axes(area, o);
  const std::int32_t margin = mirrors_columns(g, o) ? kColumns - g.width - g.column_offset : g.column_offset;
  const std::uint8_t bytes[] = {0x21, byte(margin + r.left), byte(margin + r.right - 1),  // (10.1.4)
                                0x22, byte(r.top / 8),       byte(r.bottom / 8 - 1)};     // (10.1.5)
  return send(bytes);
}

}  // namespace arcspan::hal
