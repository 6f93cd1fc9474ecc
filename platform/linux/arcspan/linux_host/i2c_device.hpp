// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstddef>

namespace arcspan::linux_host {

/// An I2C adapter of the kernel's i2c-dev (Documentation/i2c/dev-interface.rst).
class I2cDevice final : public hal::I2cBus {
 public:
  /// Longest transaction of the kernel in bytes (drivers/i2c/i2c-dev.c). Longer ones are refused, because
  /// splitting them would change their meaning.
  static constexpr std::size_t kMostBytes = 8192;

  /// Opens `path`, e.g. /dev/i2c-1. kNotReady if the device does not exist or may not be used; kUnsupported
  /// if it is not an i2c-dev or supports SMBus only. After a failure the object is closed.
  Result open(const char* path);

  /// kOk if the 7-bit `address` is free, kBusy if a kernel driver owns the device there.
  Result check_free(std::uint8_t address);

  /// errno of the last transaction that failed; 0 if none has.
  [[nodiscard]] int last_error() const { return last_error_; }

 private:
  /// Implements I2cBus::write; kNotReady if closed, kUnsupported for more than kMostBytes.
  Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) override;

  FileDescriptor file_;
  int last_error_ = 0;
};

}  // namespace arcspan::linux_host
