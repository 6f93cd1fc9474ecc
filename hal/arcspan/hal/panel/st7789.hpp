// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/dcs_panel.hpp>

namespace arcspan::hal {

inline constexpr Glass kSt7789Module{240, 320, 0, 0, false, false, false, true};

/// ST7789V (Sitronix): memory for 240 x 320; glasses of 240 x 240, 135 x 240 or 170 x 320 lie somewhere
/// in it, at the offsets that their maker names. kSt7789Module is a full IPS glass, which shows complements.
class St7789 final : public DcsPanel {
 public:
  /// `reset` may be null if the line is not connected to a pin; it is active when low. The pins and the bus
  /// must outlive the panel.
  St7789(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
         const Glass& glass = kSt7789Module, const PanelSettings& settings = {})
      : DcsPanel(bus, data_or_command, reset, clock, glass, settings) {}
};

}  // namespace arcspan::hal
