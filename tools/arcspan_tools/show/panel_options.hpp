// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <arcspan_tools/command/glass_options.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace arcspan::tools {

/// How a panel is wired to this machine.
struct PanelOptions {
  std::string spi = "/dev/spidev0.0";
  double spi_mhz = 10;
  std::string i2c;  ///< empty: the panel is on SPI
  unsigned i2c_address = 0x3C;
  /// Lines as linux_host::GpioPin takes them; empty for one that is not connected.
  std::string data_or_command;
  std::string reset;
  std::string backlight;
  std::string busy;
  GlassOptions glass;

  /// The device of the bus that is used.
  [[nodiscard]] const std::string& bus() const { return i2c.empty() ? spi : i2c; }
};

void add_panel_options(CLI::App& app, PanelOptions& options);

}  // namespace arcspan::tools
