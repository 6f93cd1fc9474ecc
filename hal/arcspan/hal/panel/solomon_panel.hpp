// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/solomon_port.hpp>

namespace arcspan::hal {

/// Common base of Ssd1306 and Ssd0323, which take parameters as command bytes. If a failure cut a command
/// short, the controller would take the next opcode for a parameter. do_configure() therefore sends a NOP for
/// every parameter that may be missing, then all settings.
class SolomonPanel : public Panel {
 protected:
  SolomonPanel(SolomonPort& port, OutputPin* reset, Clock& clock, const Glass& glass,
               const PanelSettings& settings)
      : Panel(glass, settings, clock), port_(port), reset_(reset) {}
  ~SolomonPanel() = default;

  static constexpr std::uint8_t byte(std::int32_t value) { return static_cast<std::uint8_t>(value); }
  Status send(std::span<const std::uint8_t> bytes) { return port_.command(bytes); }
  /// Sends two NOPs, since no command used here has more than two parameters.
  Status end_command();

 private:
  Status do_reset() override { return reset(); }
  Status do_sleep() override { return send_sleep(); }
  Status do_wake() override { return Status::kOk; }  // do_configure() switches the display on
  Status do_start_pixels(std::span<const std::uint8_t> wire) override { return port_.start_pixels(wire); }
  Status do_wait(std::uint32_t limit_us) override { return port_.wait(clock(), limit_us); }

  // The hooks are inline and call these, for the reason given in dcs_panel.hpp.
  Status reset();
  Status send_sleep();

  SolomonPort& port_;
  OutputPin* reset_;
};

}  // namespace arcspan::hal
