// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/dcs_panel.hpp>

namespace arcspan::hal {

inline constexpr Glass kIli9341Module{240, 320, 0, 0, true, false, true, false};

/// ILI9341 (ILI Technology, V1.11): 240 x 320, usual modules have the stripes of the glass blue first and
/// the columns mirrored, which kIli9341Module says.
class Ili9341 final : public DcsPanel {
 public:
  /// `reset` may be null if the line is not connected to a pin; it is active when low. The pins and the bus
  /// must outlive the panel.
  Ili9341(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
          const Glass& glass = kIli9341Module, const PanelSettings& settings = {})
      : DcsPanel(bus, data_or_command, reset, clock, glass, settings) {}
};

}  // namespace arcspan::hal
