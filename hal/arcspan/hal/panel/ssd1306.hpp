// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/solomon_panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

namespace arcspan::hal {

/// The usual module of 128 x 64 pixels, with the controller's first column and row at the lower right.
inline constexpr Glass kSsd1306Module{128, 64, 0, 0, true, true, false, false};
/// The module of 0.42 inches, 72 x 40 pixels, of which some makers count 70: a stripe of the memory from
/// column 28 on. It needs Ssd1306Wiring::internal_reference. Some of these are wired to rows 12 to 51
/// instead.
inline constexpr Glass kSsd1306Module72x40{72, 40, 28, 0, true, true, false, false};

/// Power supply and row wiring of an SSD1306 module.
struct Ssd1306Wiring {
  bool charge_pump = true;  ///< VCC comes from the controller's charge pump (8Dh, since rev 1.2)
  /// Rows are wired to alternating sides. False for most modules of 128 x 32 and 96 x 16 pixels.
  bool alternating_coms = true;
  /// The current of the segments has the controller's own reference, 30 uA, instead of a resistor of the
  /// module: command ADh, which the SSD1315 datasheet states, and which older SSD1306 take without effect.
  bool internal_reference = false;
};

/// SSD1306 (Solomon Systech, rev 1.1): 128 x 64 pixels of one bit, on SPI or I2C. The controller mirrors;
/// `Layout` exchanges the axes while it packs. The height of the glass is a multiple of 8. Glass::row_offset
/// is the COM of the glass's first row.
class Ssd1306 final : public SolomonPanel {
 public:
  using Layout = MonoPages;
  static constexpr std::int32_t kColumns = 128;
  static constexpr std::int32_t kRows = 64;

  /// `reset` is active low and null if not connected. All referenced objects must outlive the panel.
  Ssd1306(SolomonPort& port, OutputPin* reset, Clock& clock, const Glass& glass = kSsd1306Module,
          const PanelSettings& settings = {}, const Ssd1306Wiring& wiring = {})
      : SolomonPanel(port, reset, clock, glass, settings), wiring_(wiring) {}

 private:
  [[nodiscard]] bool do_fits() const override;
  Status do_configure() override;
  [[nodiscard]] bool do_takes(const Rect& area, std::size_t bytes) const override;
  Status do_open_window(const Rect& area) override;

  Ssd1306Wiring wiring_;
};

}  // namespace arcspan::hal
