// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/panel/dcs_panel.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A controller with the MIPI display command set: the size of its memory, and what it has to be told beside
/// the common settings (voltages, gamma, frame rate, tearing line).
struct DcsController {
  std::uint16_t columns = 240;
  std::uint16_t rows = 320;
  /// For each command its opcode, the number of its parameters, 0 ... 255, and these. They are sent whenever
  /// all settings are, before them. Reset and sleep (01h, 10h, 11h) are the driver's and are refused.
  std::span<const std::uint8_t> commands{};

  /// Whether `commands` is as stated.
  [[nodiscard]] bool is_valid() const;
};

/// A panel whose controller the program describes: ST7735, ST7796, GC9A01, ILI9486 and others that take 16
/// bits per pixel over 4-wire SPI by the commands of mipi_dcs.hpp. Brightness (51h, 53h) is sent in any case:
/// a controller without it takes unknown commands for no operation.
class CustomDcsPanel final : public DcsPanel {
 public:
  /// `reset` is active low and null if not connected. All referenced objects, among them the commands of
  /// `controller`, must outlive the panel. start() returns kInvalidArgument if they are malformed.
  CustomDcsPanel(SpiBus& bus, OutputPin& data_or_command, OutputPin* reset, Clock& clock,
                 const DcsController& controller, const Glass& glass, const PanelSettings& settings = {})
      : DcsPanel(bus, data_or_command, reset, clock, controller.columns, controller.rows, glass, settings),
        controller_(controller) {}

 private:
  [[nodiscard]] bool do_fits() const override { return DcsPanel::do_fits() && controller_.is_valid(); }
  Status do_configure() override {
    const Status status = send_commands();
    return ok(status) ? DcsPanel::do_configure() : status;
  }

  Status send_commands();

  DcsController controller_;
};

}  // namespace arcspan::hal
