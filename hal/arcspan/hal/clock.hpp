// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::hal {

/// Time as the panels need it: a free-running count of microseconds, and waiting.
///
/// Neither call can fail. Not for interrupt handlers: `delay_us` blocks.
class Clock {
 public:
  /// Microseconds since any fixed moment, modulo 2^32 (it wraps after about 71 minutes). Only the difference
  /// of two readings, taken as an unsigned number, has a meaning.
  [[nodiscard]] std::uint32_t now_us() { return do_now_us(); }

  /// Returns after at least `us` microseconds; may take longer, never shorter.
  void delay_us(std::uint32_t us) {
    if (us != 0) do_delay_us(us);
  }

  /// Returns after at least `ms` milliseconds, 0 ... 4,294,967; a longer time is cut to the longest.
  void delay_ms(std::uint32_t ms) { delay_us(ms > kMaxMilliseconds ? UINT32_MAX : ms * 1000U); }

 protected:
  ~Clock() = default;

 private:
  static constexpr std::uint32_t kMaxMilliseconds = UINT32_MAX / 1000U;

  [[nodiscard]] virtual std::uint32_t do_now_us() = 0;
  /// `us` is at least 1.
  virtual void do_delay_us(std::uint32_t us) = 0;
};

}  // namespace arcspan::hal
