// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/mipi_dcs.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

namespace arcspan::hal {

/// What ILI9341 and ST7789 have in common: 240 x 320 pixels of memory behind the MIPI display command set,
/// 4-wire SPI, 16 bits a pixel. All four orientations are the controller's own. Voltages and gamma stay as
/// reset leaves them. Brightness works where the backlight hangs on the controller's own output.
class DcsPanel : public Panel {
 public:
  using Layout = BigEndianRgb565;
  static constexpr std::int32_t kColumns = 240;
  static constexpr std::int32_t kRows = 320;

 protected:
  DcsPanel(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock, const Glass& glass,
           const PanelSettings& settings)
      : Panel(glass, settings, clock), port_(bus, data_or_command), reset_(reset) {}
  ~DcsPanel() = default;

 private:
  [[nodiscard]] bool do_fits() const override { return fits(); }
  Status do_reset() override { return reset(); }
  Status do_configure() override { return configure(); }
  Status do_sleep() override { return send_sleep(); }
  Status do_wake() override { return send_wake(); }
  [[nodiscard]] bool do_takes(const Rect& area, std::size_t bytes) const override {
    return takes(area, bytes);
  }
  Status do_open_window(const Rect& area) override { return open_window(area); }
  Status do_start_pixels(std::span<const std::uint8_t> wire) override { return port_.start_data(wire); }
  Status do_wait(std::uint32_t limit_us) override { return port_.bus().wait(clock(), limit_us); }

  Status send(const dcs::Command& command) { return port_.command(command.opcode, command.parameters()); }
  Status pulse_reset();

  // The hooks are inline, so that a panel outside the library can derive with RTTI from what is built
  // without.
  Status configure();
  [[nodiscard]] bool fits() const;
  Status open_window(const Rect& area);
  Status reset();
  Status send_sleep();
  [[nodiscard]] bool takes(const Rect& area, std::size_t bytes) const;
  Status send_wake();

  CommandPort port_;
  OutputPin* reset_;
};

}  // namespace arcspan::hal
