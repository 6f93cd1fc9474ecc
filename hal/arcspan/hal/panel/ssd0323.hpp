// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/solomon_panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

namespace arcspan::hal {

/// Osram's Pictiva module of 128 x 64 pixels, with the controller's first row at the bottom. The row offset
/// differs between modules.
inline constexpr Glass kSsd0323Module{128, 64, 0, 0, false, true, false, false};

/// SSD0323 (Solomon Systech): 128 x 80 pixels of 16 grey levels, on SPI. The controller mirrors; `Layout`
/// exchanges the axes while it packs. Width and column offset of the glass must be even.
class Ssd0323 final : public SolomonPanel {
 public:
  using Layout = Gray4Pairs;
  static constexpr std::int32_t kColumns = 128;
  static constexpr std::int32_t kRows = 80;

  /// `split_coms`: odd rows are wired to one side of the glass, even rows to the other. `reset` is active low
  /// and null if not connected. All referenced objects must outlive the panel.
  Ssd0323(SolomonPort& port, OutputPin* reset, Clock& clock, const Glass& glass = kSsd0323Module,
          const PanelSettings& settings = {}, bool split_coms = true)
      : SolomonPanel(port, reset, clock, glass, settings), split_coms_(split_coms) {}

 private:
  [[nodiscard]] bool do_fits() const override;
  Status do_configure() override;
  [[nodiscard]] bool do_takes(const Rect& area, std::size_t bytes) const override;
  Status do_open_window(const Rect& area) override;

  bool split_coms_;
};

}  // namespace arcspan::hal
