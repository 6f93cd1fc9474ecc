// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::hal {

/// One input wire: the busy line of a display.
class InputPin {
 public:
  /// Microseconds between two looks at the wire in `wait_for`.
  static constexpr std::uint32_t kPollIntervalUs = 10;

  /// Puts what the wire carries now into `level`. kTransferFailed if it could not be read (a port expander, a
  /// line that the kernel took away); `level` is unchanged then. Does not wait for the wire.
  Status read(Level& level) { return do_read(level); }

  /// Blocks until the wire carries `level`: kTimeout if it does not within `limit_us` (0 ... 2^31 - 1; with 0
  /// it is looked at once), kInvalidArgument for a limit outside the range or a value that is no Level,
  /// without looking; otherwise the first status of the pin that is not kOk. `clock` must run.
  Status wait_for(Level level, Clock& clock, std::uint32_t limit_us);

 protected:
  ~InputPin() = default;

 private:
  virtual Status do_read(Level& level) = 0;
};

}  // namespace arcspan::hal
