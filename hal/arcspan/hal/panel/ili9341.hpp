// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/dcs_panel.hpp>

namespace arcspan::hal {

inline constexpr Glass kIli9341Module{240, 320, 0, 0, true, false, true, false};

/// ILI9341 (ILI Technology, V1.11), 240 x 320 pixels. kIli9341Module describes the usual modules, with
/// mirrored columns and subpixels in the order blue, green, red.
class Ili9341 final : public DcsPanel {
 public:
  /// `reset` is active low and null if not connected. All referenced objects must outlive the panel.
  Ili9341(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
          const Glass& glass = kIli9341Module, const PanelSettings& settings = {})
      : DcsPanel(bus, data_or_command, reset, clock, 240, 320, glass, settings) {}
};

}  // namespace arcspan::hal
