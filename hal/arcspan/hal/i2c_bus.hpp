// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A write-only I2C bus on which this side is the controller. Board code derives from it.
class I2cBus {
 public:
  /// Range of 7-bit device addresses. The others are reserved (I2C specification, 3.1.12).
  static constexpr std::uint8_t kFirstAddress = 0x08;
  static constexpr std::uint8_t kLastAddress = 0x77;

  /// Sends `bytes` to the device at the 7-bit `address` as one transaction. Blocks until the stop condition.
  ///
  /// - kInvalidArgument: `address` is out of range or `bytes` is empty; nothing is sent
  /// - kTransferFailed: no device acknowledged the address, or arbitration was lost
  /// - kTransferShort: the device stopped acknowledging
  /// - kTimeout: the device held the clock for too long
  Status write(std::uint8_t address, std::span<const std::uint8_t> bytes) {
    if (address < kFirstAddress || address > kLastAddress || bytes.empty()) return Status::kInvalidArgument;
    return do_write(address, bytes);
  }

 protected:
  ~I2cBus() = default;

 private:
  /// Implements `write` for valid arguments.
  virtual Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace arcspan::hal
