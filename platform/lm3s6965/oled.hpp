// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/ssd0323.hpp>

#include <board_clock.hpp>
#include <port_pin.hpp>
#include <ssi.hpp>

namespace arcspan::lm3s6965 {

/// The board's display of 128 x 64 pixels with its wiring: an SSD0323 on SSI0 with D/C at PC7. PD0 high
/// selects it in place of the SD card on the same bus. It is reset together with the board.
class Oled {
 public:
  /// Selects the display and starts it. Call start_clocks() first. Returns the statuses of Panel::start.
  Status start() {
    const Status status = select_.set(hal::Level::kHigh);
    return ok(status) ? panel_.start() : status;
  }
  [[nodiscard]] hal::Ssd0323& panel() { return panel_; }

 private:
  BoardClock clock_;
  Ssi bus_;
  PortPin data_or_command_{Port::kC, 7};
  PortPin select_{Port::kD, 0};
  hal::SolomonSpi port_{bus_, data_or_command_};
  // The glass begins at the controller's row 12 (OSRAM_INIT_OFFSET 4Ch in Luminary Micro's driver).
  hal::Ssd0323 panel_{port_, nullptr, clock_, hal::Glass{128, 64, 0, 12, false, true, false, false}};
};

}  // namespace arcspan::lm3s6965
