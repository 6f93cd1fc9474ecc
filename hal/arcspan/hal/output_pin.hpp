// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::hal {

/// Electrical level of a pin. An active-low reset pin is set to kLow in order to reset.
enum class Level : std::uint8_t { kLow, kHigh };

/// A digital output: D/C, reset, backlight. Board code derives from it.
class OutputPin {
 public:
  /// Drives the pin to `level` before it returns. kInvalidArgument if `level` is not a Level; the pin is
  /// unchanged. kTransferFailed if it could not be set (port expander, line withdrawn by the kernel); its
  /// level is then unknown.
  Status set(Level level) {
    if (level != Level::kLow && level != Level::kHigh) return Status::kInvalidArgument;
    return do_set(level);
  }

 protected:
  ~OutputPin() = default;

 private:
  virtual Status do_set(Level level) = 0;
};

}  // namespace arcspan::hal
