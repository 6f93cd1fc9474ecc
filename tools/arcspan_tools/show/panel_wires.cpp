// SPDX-License-Identifier: MIT
#include <arcspan_tools/show/panel_wires.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <cmath>
#include <cstring>

namespace arcspan::tools {
namespace {

using hal::Level;

void take(linux_host::GpioPin& pin, const char* option, const std::string& line, Level level) {
  if (line.empty()) return;
  const linux_host::Result result = pin.request(line, level);
  if (!ok(result)) throw Failure(std::string(option) + " " + line, result.text());
}

linux_host::SpiSettings settings_of(const PanelOptions& options) {
  return {static_cast<std::uint32_t>(std::lround(options.spi_mhz * 1e6)), 0};
}

}  // namespace

PanelWires::PanelWires(const PanelOptions& options)
    : spi_name_(options.spi), backlight_name_(options.backlight) {
  if (options.data_or_command.empty()) throw Failure("--dc", "the panel's D/C line has to be given");
  const linux_host::Result opened = spi_.open(options.spi.c_str(), settings_of(options));
  if (!ok(opened)) throw Failure(options.spi, opened.text());
  take(data_or_command_, "--dc", options.data_or_command, Level::kLow);
  take(reset_, "--reset", options.reset, Level::kHigh);
  take(backlight_, "--backlight", options.backlight, Level::kLow);
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
  const int error = spi_.last_error();
  throw Failure(spi_name_, std::string(to_string(status)) +
                               (error == 0 ? "" : std::string(" (") + std::strerror(error) + ")"));
}

}  // namespace arcspan::tools
