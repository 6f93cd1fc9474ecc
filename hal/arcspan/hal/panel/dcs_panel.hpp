// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/output_pin.hpp>
#include <arcspan/hal/panel/command_port.hpp>
#include <arcspan/hal/panel/mipi_dcs.hpp>
#include <arcspan/hal/panel/panel.hpp>
#include <arcspan/hal/panel/wire_layout.hpp>

namespace arcspan::hal {

/// Common base of Ili9341, St7789 and CustomDcsPanel: pixels of 16 bits behind the MIPI display command set,
/// 4-wire SPI.
///
/// The controller performs all four orientations. Voltages and gamma keep their reset values unless a
/// CustomDcsPanel sets them. Brightness has an effect only if the controller drives the backlight.
class DcsPanel : public Panel {
 public:
  using Layout = BigEndianRgb565;

 protected:
  /// `columns` and `rows` of the controller's memory.
  DcsPanel(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock, std::uint16_t columns,
           std::uint16_t rows, const Glass& glass, const PanelSettings& settings)
      : Panel(glass, settings, clock),
        port_(bus, data_or_command),
        reset_(reset),
        columns_(columns),
        rows_(rows) {}
  ~DcsPanel() = default;

  [[nodiscard]] bool do_fits() const override { return glass().fits(columns_, rows_); }
  Status do_configure() override { return configure(); }

  Status send(std::uint8_t opcode, std::span<const std::uint8_t> parameters) {
    return port_.command(opcode, parameters);
  }

 private:
  Status do_reset() override { return reset(); }
  Status do_sleep() override { return send_sleep(); }
  Status do_wake() override { return send_wake(); }
  [[nodiscard]] bool do_takes(const Rect& area, std::size_t bytes) const override {
    return takes(area, bytes);
  }
  Status do_open_window(const Rect& area) override { return open_window(area); }
  Status do_start_pixels(std::span<const std::uint8_t> wire) override { return port_.start_data(wire); }
  Status do_wait(std::uint32_t limit_us) override { return port_.bus().wait(clock(), limit_us); }

  Status send(const dcs::Command& command) { return send(command.opcode, command.parameters()); }
  Status pulse_reset();

  // The hooks are inline and call these, so that no key function ties the type information to the library: a
  // panel outside it may be compiled with RTTI although the library is not.
  Status configure();
  Status open_window(const Rect& area);
  Status reset();
  Status send_sleep();
  [[nodiscard]] bool takes(const Rect& area, std::size_t bytes) const;
  Status send_wake();

  CommandPort port_;
  OutputPin* reset_;
  std::uint16_t columns_;
  std::uint16_t rows_;
};

}  // namespace arcspan::hal
