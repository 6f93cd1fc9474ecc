// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/dcs_panel.hpp>

namespace arcspan::hal {

inline constexpr Glass kSt7789Module{240, 320, 0, 0, false, false, false, true};

/// ST7789V (Sitronix) with memory for 240 x 320 pixels. Smaller glasses (240 x 240, 135 x 240, 170 x 320) lie
/// in it at offsets that the module's maker states. kSt7789Module is a full-size IPS glass, which is
/// inverted.
class St7789 final : public DcsPanel {
 public:
  /// `reset` is active low and null if not connected. All referenced objects must outlive the panel.
  St7789(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
         const Glass& glass = kSt7789Module, const PanelSettings& settings = {})
      : DcsPanel(bus, data_or_command, reset, clock, 240, 320, glass, settings) {}
};

}  // namespace arcspan::hal
