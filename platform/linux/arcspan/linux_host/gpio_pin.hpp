// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/linux_host/gpio/backend.hpp>
#include <arcspan/linux_host/result.hpp>

#include <string>

namespace arcspan::linux_host {

/// An output line of a GPIO chip, held through libgpiod until release() or destruction. Most chips keep the
/// level after that.
class GpioPin final : public hal::OutputPin {
 public:
  GpioPin() = default;
  GpioPin(const GpioPin&) = delete;
  GpioPin& operator=(const GpioPin&) = delete;
  ~GpioPin() { release(); }

  /// Releases the present line, requests the one with this `name`, such as `gpiochip0:25` or its own name,
  /// and drives it to `level`. Returns the statuses of gpio::find_line_address and gpio::request_output;
  /// kUnsupported if arcspan was built without libgpiod.
  Result request(const std::string& name, hal::Level level);

  void release() { gpio::release(line_); }
  [[nodiscard]] bool is_held() const { return line_.line != nullptr; }

 private:
  /// Implements OutputPin::set; kNotReady if no line is held.
  Status do_set(hal::Level level) override;

  gpio::HeldLine line_;
};

/// An input line of a GPIO chip, held through libgpiod until release() or destruction.
class GpioInput final : public hal::InputPin {
 public:
  GpioInput() = default;
  GpioInput(const GpioInput&) = delete;
  GpioInput& operator=(const GpioInput&) = delete;
  ~GpioInput() { release(); }

  /// Requests the line with this `name`, as GpioPin::request does.
  Result request(const std::string& name);

  void release() { gpio::release(line_); }
  [[nodiscard]] bool is_held() const { return line_.line != nullptr; }

 private:
  /// Implements InputPin::read; kNotReady if no line is held.
  Status do_read(hal::Level& level) override;

  gpio::HeldLine line_;
};

}  // namespace arcspan::linux_host
