// SPDX-License-Identifier: MIT
#include <arcspan_tools/command/number_range.hpp>
#include <arcspan_tools/show/panel_options.hpp>

namespace arcspan::tools {

void add_panel_options(CLI::App& app, PanelOptions& options) {
  const std::string group = "Panel on an SPI bus";
  app.add_option("--spi", options.spi, "its bus (default " + options.spi + ")")->group(group);
  app.add_option("--spi-mhz", options.spi_mhz, "clock of the bus (default 10)")
      ->type_name("0.1...200")
      ->check(number_range(0.1, 200, "0.1...200"))
      ->group(group);
  const std::string line = "LINE";
  app.add_option("--dc", options.data_or_command,
                 "line of D/C: a name, e.g. GPIO25, or CHIP:OFFSET, e.g. gpiochip0:25")
      ->type_name(line)
      ->group(group);
  app.add_option("--reset", options.reset, "line of the reset, which is active when low")
      ->type_name(line)
      ->group(group);
  app.add_option("--backlight", options.backlight, "line of the backlight, on when high")
      ->type_name(line)
      ->group(group);
  app.add_option("--rotate", options.rotation, "degrees clockwise (default 0)")
      ->type_name("0|90|180|270")
      ->check(CLI::IsMember({0, 90, 180, 270}))
      ->group(group);
}

}  // namespace arcspan::tools
