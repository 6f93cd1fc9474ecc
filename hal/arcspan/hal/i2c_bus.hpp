// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan::hal {

/// An I2C bus of which this library is the controller; panels are only ever written to.
class I2cBus {
 public:
  /// The 7-bit addresses that a device may have; those outside are reserved (I2C specification, 3.1.12).
  static constexpr std::uint8_t kFirstAddress = 0x08;
  static constexpr std::uint8_t kLastAddress = 0x77;

  /// Sends `bytes` to the device at the 7-bit `address` as one transaction, start to stop. Blocks until the
  /// stop condition.
  ///
  /// kInvalidArgument for an address outside kFirstAddress ... kLastAddress or an empty `bytes`, without
  /// touching the bus; kTransferFailed if nothing acknowledged the address or the bus was lost;
  /// kTransferShort if the device stopped acknowledging; kTimeout if the device held the clock for too long.
  Status write(std::uint8_t address, std::span<const std::uint8_t> bytes) {
    if (address < kFirstAddress || address > kLastAddress || bytes.empty()) return Status::kInvalidArgument;
    return do_write(address, bytes);
  }

 protected:
  ~I2cBus() = default;

 private:
  virtual Status do_write(std::uint8_t address, std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace arcspan::hal
