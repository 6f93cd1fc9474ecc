// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/bare/board.hpp>
#include <arcspan/hal/clock.hpp>

#include <cstdint>

namespace arcspan::lm3s6965 {

/// Time from the processor clock. After reset this is the internal oscillator, 12 MHz +-30 % (LM3S6965 data
/// sheet, 5.2.4). It is counted as 16 MHz, more than the fastest, so that a delay is never too short.
class BoardClock final : public hal::Clock {
 private:
  static constexpr std::uint64_t kTicksPerMicrosecond = 16;

  std::uint32_t do_now_us() override {
    return static_cast<std::uint32_t>(bare::ticks() / kTicksPerMicrosecond);
  }
  void do_delay_us(std::uint32_t us) override {
    const std::uint64_t end = bare::ticks() + us * kTicksPerMicrosecond;
    while (bare::ticks() < end) {
    }
  }
};

}  // namespace arcspan::lm3s6965
