// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/gpio/line_name.hpp>
#include <arcspan/linux_host/gpio_pin.hpp>

namespace arcspan::linux_host {

Result GpioPin::request(const std::string& name, hal::Level level) {
  release();
  gpio::LineAddress address;
  if (const Result found = gpio::find_line_address(name, address); !linux_host::ok(found)) return found;
  return gpio::request_output(address.chip_path.c_str(), address.offset, level == hal::Level::kHigh, line_);
}

Status GpioPin::do_set(hal::Level level) { return gpio::set_value(line_, level == hal::Level::kHigh).status; }

Result GpioInput::request(const std::string& name) {
  release();
  gpio::LineAddress address;
  if (const Result found = gpio::find_line_address(name, address); !linux_host::ok(found)) return found;
  return gpio::request_input(address.chip_path.c_str(), address.offset, line_);
}

Status GpioInput::do_read(hal::Level& level) {
  bool high = false;
  const Status status = gpio::get_value(line_, high).status;
  if (arcspan::ok(status)) level = high ? hal::Level::kHigh : hal::Level::kLow;
  return status;
}

}  // namespace arcspan::linux_host
