// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/i2c_bus.hpp>
#include <arcspan/linux_host/file_descriptor.hpp>
#include <arcspan/linux_host/result.hpp>

#include <cstddef>

namespace arcspan::linux_host {

/// An I2C adapter, through the kernel's i2c-dev (Documentation/i2c/dev-interface.rst).
class I2cDevice final : public hal::I2cBus {
 public:
  /// The longest transaction that the kernel takes (drivers/i2c/i2c-dev.c); a longer one would have to be
  /// cut, which is not what `write` promises.
  static constexpr std::size_t kMostBytes = 8192;

  /// Opens `path`, e.g. /dev/i2c-1. kNotReady if there is no such device or it may not be used, kUnsupported
  /// if it is no i2c-dev or an adapter for SMBus only. After a failure the object is closed.
  Result open(const char* path);

  /// Whether the 7-bit `address` is free: kBusy if a driver of the kernel owns the device there.
  Result check_free(std::uint8_t address);

  /// The errno of the last transaction that failed; 0 if none has.
  [[nodiscard]] int last_error() const { return last_error_; }

 private:
  /// As I2cBus::write; kNotReady on a closed object, kUnsupported for more than kMostBytes.
  Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) override;

  FileDescriptor file_;
  int last_error_ = 0;
};

}  // namespace arcspan::linux_host
