// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/clock.hpp>

namespace arcspan::linux_host {

/// The kernel's CLOCK_MONOTONIC. It is never set back, and signals do not shorten a delay.
class MonotonicClock final : public hal::Clock {
 private:
  [[nodiscard]] std::uint32_t do_now_us() override;
  void do_delay_us(std::uint32_t us) override;
};

}  // namespace arcspan::linux_host
