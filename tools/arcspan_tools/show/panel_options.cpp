// SPDX-License-Identifier: MIT
#include <arcspan/hal/i2c_bus.hpp>

#include <arcspan_tools/command/number_range.hpp>
#include <arcspan_tools/show/panel_options.hpp>

namespace arcspan::tools {
namespace {

constexpr const char* kGroup = "Panel on an SPI or I2C bus";

CLI::Option* add_line(CLI::App& app, const char* name, std::string& line, const char* help) {
  return app.add_option(name, line, help)->type_name("LINE")->group(kGroup);
}

void add_bus_options(CLI::App& app, PanelOptions& options) {
  CLI::Option* spi =
      app.add_option("--spi", options.spi, "its bus (default " + options.spi + ")")->group(kGroup);
  CLI::Option* mhz = app.add_option("--spi-mhz", options.spi_mhz, "clock of the bus (default 10)")
                         ->type_name("0.1...200")
                         ->check(number_range(0.1, 200, "0.1...200"))
                         ->group(kGroup);
  CLI::Option* i2c = app.add_option("--i2c", options.i2c, "its bus if it is on I2C, e.g. /dev/i2c-1; ssd1306")
                         ->excludes(spi)
                         ->excludes(mhz)
                         ->group(kGroup);
  app.add_option("--i2c-address", options.i2c_address, "its address there (default 0x3c)")
      ->type_name("0x08...0x77")
      ->check(CLI::Range(unsigned{hal::I2cBus::kFirstAddress}, unsigned{hal::I2cBus::kLastAddress}))
      ->needs(i2c)
      ->group(kGroup);
  add_line(app, "--dc", options.data_or_command,
           "line of D/C on SPI: a name, e.g. GPIO25, or CHIP:OFFSET, e.g. gpiochip0:25")
      ->excludes(i2c);
  add_line(app, "--busy", options.busy, "line on which the panel says that it is busy, when high; SPI")
      ->excludes(i2c);
}

}  // namespace

void add_panel_options(CLI::App& app, PanelOptions& options) {
  add_bus_options(app, options);
  add_line(app, "--reset", options.reset, "line of the reset, which is active when low");
  add_line(app, "--backlight", options.backlight, "line of the backlight, on when high");
  add_glass_options(app, options.glass);
  app.get_option("--i2c")->excludes("--spi-mode");
}

}  // namespace arcspan::tools
