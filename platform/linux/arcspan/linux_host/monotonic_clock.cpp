// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/monotonic_clock.hpp>

#include <cerrno>
#include <ctime>

namespace arcspan::linux_host {
namespace {

constexpr long kNanosecondsPerSecond = 1'000'000'000;
constexpr std::uint32_t kMicrosecondsPerSecond = 1'000'000;

timespec now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time;
}

}  // namespace

std::uint32_t MonotonicClock::do_now_us() {
  const timespec time = now();
  return static_cast<std::uint32_t>(time.tv_sec) * kMicrosecondsPerSecond +
         static_cast<std::uint32_t>(time.tv_nsec / 1000);
}

void MonotonicClock::do_delay_us(std::uint32_t us) {
  timespec until = now();
  until.tv_sec += static_cast<time_t>(us / kMicrosecondsPerSecond);
  until.tv_nsec += static_cast<long>(us % kMicrosecondsPerSecond) * 1000;
  if (until.tv_nsec >= kNanosecondsPerSecond) {
    until.tv_nsec -= kNanosecondsPerSecond;
    ++until.tv_sec;
  }
  // The end is absolute, so that waits interrupted by signals do not add up.
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace arcspan::linux_host
