// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan::hal {

/// A free-running microsecond counter and delays. Board code derives from it.
///
/// No call can fail. `delay_us` blocks, so it must not be called from an interrupt handler.
class Clock {
 public:
  /// Microseconds since an arbitrary moment, modulo 2^32 (wraps after about 71 minutes). Compare two readings
  /// only by their unsigned difference.
  [[nodiscard]] std::uint32_t now_us() { return do_now_us(); }

  /// Blocks for at least `us` microseconds.
  void delay_us(std::uint32_t us) {
    if (us != 0) do_delay_us(us);
  }

  /// Blocks for at least `ms` milliseconds, 0 ... 4,294,967. Longer delays are shortened to the maximum.
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
