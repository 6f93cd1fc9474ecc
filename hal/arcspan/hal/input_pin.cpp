// SPDX-License-Identifier: MIT
#include <arcspan/hal/input_pin.hpp>

namespace arcspan::hal {

Status InputPin::wait_for(Level level, Clock& clock, std::uint32_t limit_us) {
  if (limit_us > INT32_MAX || (level != Level::kLow && level != Level::kHigh))
    return Status::kInvalidArgument;
  const std::uint32_t begin = clock.now_us();
  while (true) {
    Level now = Level::kLow;
    const Status status = read(now);
    if (!ok(status) || now == level) return status;
    // The unsigned difference is right even if the counter wraps while waiting.
    if (clock.now_us() - begin >= limit_us) return Status::kTimeout;
    clock.delay_us(kPollIntervalUs);
  }
}

}  // namespace arcspan::hal
