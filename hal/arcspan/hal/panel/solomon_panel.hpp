// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/solomon_port.hpp>

namespace arcspan::hal {

/// What SSD1306 and SSD0323 have in common: parameters are command bytes, so a command that was cut short
/// would take the next one's opcode for a parameter. What restores order is a NOP for every parameter that
/// may be missing, and all settings after it.
class SolomonPanel : public Panel {
 protected:
  SolomonPanel(SolomonPort& port, OutputPin* reset, Clock& clock, const Glass& glass,
               const PanelSettings& settings)
      : Panel(glass, settings, clock), port_(port), reset_(reset) {}
  ~SolomonPanel() = default;

  Status send(std::span<const std::uint8_t> bytes) { return port_.command(bytes); }
  /// Two NOPs: no command that is used here has more parameters.
  Status end_command();

 private:
  Status do_reset() override { return reset(); }
  Status do_sleep() override { return send_sleep(); }
  Status do_wake() override { return Status::kOk; }  // do_configure ends with display on
  Status do_start_pixels(std::span<const std::uint8_t> wire) override { return port_.start_pixels(wire); }
  Status do_wait(std::uint32_t limit_us) override { return port_.wait(clock(), limit_us); }

  // The hooks are inline, so that a panel outside the library can derive with RTTI from what is built
  // without.
  Status reset();
  Status send_sleep();

  SolomonPort& port_;
  OutputPin* reset_;
};

}  // namespace arcspan::hal
