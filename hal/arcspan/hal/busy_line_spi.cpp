// SPDX-License-Identifier: MIT
#include <arcspan/hal/busy_line_spi.hpp>

namespace arcspan::hal {

Status BusyLineSpi::wait_until_ready() {
  const Level ready = line_.busy == Level::kHigh ? Level::kLow : Level::kHigh;
  return pin_.wait_for(ready, clock_, line_.limit_us);
}

Status BusyLineSpi::do_write(std::span<const std::uint8_t> bytes) {
  const Status status = wait_until_ready();
  return ok(status) ? bus_.write(bytes) : status;
}

Status BusyLineSpi::do_start(std::span<const std::uint8_t> bytes) {
  const Status status = wait_until_ready();
  return ok(status) ? bus_.start(bytes) : status;
}

// A limit of 0 us abandons the inner transfer at once. The outer wait() returns its own kTimeout.
void BusyLineSpi::do_abort() { (void)bus_.wait(clock_, 0); }

}  // namespace arcspan::hal
