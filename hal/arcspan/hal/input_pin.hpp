// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>
#include <arcspan/hal/output_pin.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::hal {

/// A digital input, such as the busy line of a display. Board code derives from it.
class InputPin {
 public:
  /// Microseconds between two readings in `wait_for`.
  static constexpr std::uint32_t kPollIntervalUs = 10;

  /// Stores the present level in `level` without waiting. kTransferFailed if the pin cannot be read (port
  /// expander, line withdrawn by the kernel); `level` is then unchanged.
  Status read(Level& level) { return do_read(level); }

  /// Blocks until the pin has `level`. `clock` must be running.
  ///
  /// - kTimeout: the pin did not reach it within `limit_us`, 0 ... 2^31 - 1; with 0 it is read once
  /// - kInvalidArgument: `limit_us` is out of range or `level` is not a Level; the pin is not read
  /// - others: the first failure of `read`
  Status wait_for(Level level, Clock& clock, std::uint32_t limit_us);

 protected:
  ~InputPin() = default;

 private:
  virtual Status do_read(Level& level) = 0;
};

}  // namespace arcspan::hal
