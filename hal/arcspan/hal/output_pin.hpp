// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::hal {

/// What a wire carries, not what it means: a reset line that is active when low is driven `kLow` to reset.
enum class Level : std::uint8_t { kLow, kHigh };

/// One output wire: D/C, reset, backlight.
class OutputPin {
 public:
  /// Drives the wire to `level` before it returns. kInvalidArgument for a value that is no Level, without
  /// touching the wire; otherwise what the pin reports: kTransferFailed if the level could not be set (a
  /// port expander, a line that the kernel took away), after which the wire's level is unknown.
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
