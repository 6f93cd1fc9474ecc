// SPDX-License-Identifier: MIT
#include <arcspan_tools/show/panel_wires.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cmath>
#include <cstring>

namespace arcspan::tools {
namespace {

using hal::Level;

void require(const linux_host::Result& result, const std::string& subject) {
  if (!ok(result)) throw Failure(subject, result.text());
}

void take(linux_host::GpioPin& pin, const char* option, const std::string& line, Level level) {
  if (!line.empty()) require(pin.request(line, level), std::string(option) + " " + line);
}

linux_host::SpiSettings spi_settings_of(const PanelOptions& options) {
  return {static_cast<std::uint32_t>(std::lround(options.spi_mhz * 1e6)),
          static_cast<std::uint8_t>(options.glass.spi_mode)};
}

}  // namespace

PanelWires::PanelWires(const PanelOptions& options)
    : bus_name_(options.bus()), backlight_name_(options.backlight) {
  if (options.i2c.empty()) {
    open_spi(options);
  } else {
    open_i2c(options);
  }
  take(reset_, "--reset", options.reset, Level::kHigh);
  take(backlight_, "--backlight", options.backlight, Level::kLow);
}

void PanelWires::open_spi(const PanelOptions& options) {
  if (options.data_or_command.empty()) throw Failure("--dc", "the panel's D/C line has to be given");
  require(spi_.open(options.spi.c_str(), spi_settings_of(options)), options.spi);
  take(data_or_command_, "--dc", options.data_or_command, Level::kLow);
  if (!options.busy.empty()) require(busy_.request(options.busy), "--busy " + options.busy);
}

void PanelWires::open_i2c(const PanelOptions& options) {
  require(i2c_.open(options.i2c.c_str()), options.i2c);
  require(i2c_.check_free(static_cast<std::uint8_t>(options.i2c_address)), options.i2c);
}

hal::SpiBus& PanelWires::spi() {
  if (busy_.is_held()) return paced_spi_;
  return spi_;
}

PanelWires::~PanelWires() {
  if (backlight_.is_held()) (void)backlight_.set(Level::kLow);
}

void PanelWires::light(bool on) {
  if (!backlight_.is_held()) return;
  const Status status = backlight_.set(on ? Level::kHigh : Level::kLow);
  if (!ok(status)) throw Failure("--backlight " + backlight_name_, to_string(status));
}

void PanelWires::check(Status status) const {
  if (ok(status)) return;
  const int error = spi_.last_error() != 0 ? spi_.last_error() : i2c_.last_error();
  throw Failure(bus_name_, std::string(to_string(status)) +
                               (error == 0 ? "" : std::string(" (") + std::strerror(error) + ")"));
}

}  // namespace arcspan::tools
