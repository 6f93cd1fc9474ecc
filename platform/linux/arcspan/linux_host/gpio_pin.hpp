// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/input_pin.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/linux_host/gpio/backend.hpp>
#include <arcspan/linux_host/result.hpp>

#include <string>

namespace arcspan::linux_host {

/// An output line of a GPIO chip, held through libgpiod until `release` or the object's end. What a line does
/// after that is its chip's affair: most keep the level.
class GpioPin final : public hal::OutputPin {
 public:
  GpioPin() = default;
  GpioPin(const GpioPin&) = delete;
  GpioPin& operator=(const GpioPin&) = delete;
  ~GpioPin() { release(); }

  /// Takes the line that `name` means, `gpiochip0:25` or the line's name, and drives it to `level`. Statuses
  /// as gpio::find_line_address and gpio::request_output; kUnsupported where arcspan was built without
  /// libgpiod. A line that this object held is released first.
  Result request(const std::string& name, hal::Level level);

  void release() { gpio::release(line_); }
  [[nodiscard]] bool is_held() const { return line_.line != nullptr; }

 private:
  /// As OutputPin::set; kNotReady if no line is held.
  Status do_set(hal::Level level) override;

  gpio::HeldLine line_;
};

/// An input line of a GPIO chip, held through libgpiod until `release` or the object's end.
class GpioInput final : public hal::InputPin {
 public:
  GpioInput() = default;
  GpioInput(const GpioInput&) = delete;
  GpioInput& operator=(const GpioInput&) = delete;
  ~GpioInput() { release(); }

  /// Takes the line that `name` means, as GpioPin::request.
  Result request(const std::string& name);

  void release() { gpio::release(line_); }
  [[nodiscard]] bool is_held() const { return line_.line != nullptr; }

 private:
  /// As InputPin::read; kNotReady if no line is held.
  Status do_read(hal::Level& level) override;

  gpio::HeldLine line_;
};

}  // namespace arcspan::linux_host
