// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/busy_line_spi.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>
#include <arcspan/linux_host/i2c_device.hpp>
#include <arcspan/linux_host/monotonic_clock.hpp>
#include <arcspan/linux_host/spi_device.hpp>

#include <arcspan_tools/show/panel_options.hpp>

namespace arcspan::tools {

/// The bus and the pins of a panel, taken from the kernel.
class PanelWires {
 public:
  /// Takes them: reset not active, backlight off. Throws Failure, with none of them taken.
  explicit PanelWires(const PanelOptions& options);
  PanelWires(const PanelWires&) = delete;
  PanelWires& operator=(const PanelWires&) = delete;
  /// Switches the backlight off and gives everything back.
  ~PanelWires();

  /// The one of the two that the panel is on.
  [[nodiscard]] hal::SpiBus& spi();
  [[nodiscard]] hal::I2cBus& i2c() { return i2c_; }
  [[nodiscard]] hal::OutputPin& data_or_command() { return data_or_command_; }
  /// Null if it is not connected.
  [[nodiscard]] hal::OutputPin* reset() { return reset_.is_held() ? &reset_ : nullptr; }
  [[nodiscard]] hal::Clock& clock() { return clock_; }

  /// Switches the backlight, if there is one. Throws Failure.
  void light(bool on);

  /// Throws a Failure that names the bus, and what the kernel said, for a status that is not kOk.
  void check(Status status) const;

 private:
  void open_spi(const PanelOptions& options);
  void open_i2c(const PanelOptions& options);

  std::string bus_name_;
  std::string backlight_name_;
  linux_host::SpiDevice spi_;
  linux_host::I2cDevice i2c_;
  linux_host::GpioPin data_or_command_;
  linux_host::GpioPin reset_;
  linux_host::GpioPin backlight_;
  linux_host::GpioInput busy_;
  linux_host::MonotonicClock clock_;
  hal::BusyLineSpi paced_spi_{spi_, busy_, clock_};
};

}  // namespace arcspan::tools
