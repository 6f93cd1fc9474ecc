// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <ctime>

namespace arcspan::linux_host {

/// Holds back the signals that ask a program to end (SIGINT, SIGTERM, SIGHUP, SIGQUIT), so that it can look
/// for them where it is able to stop, and leave devices as it found them. Those that were ignored stay
/// ignored. For the one thread of a program; at its end the signals act as before.
class SignalWatch {
 public:
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

  /// The signal that has come, or 0; told once. Does not block.
  [[nodiscard]] int poll();

  /// Waits until a signal comes, which it returns, or until CLOCK_MONOTONIC reaches `until`: 0.
  [[nodiscard]] int wait_until(const timespec& until);

  /// Waits for a signal and returns it.
  [[nodiscard]] int wait();

 private:
  sigset_t watched_;
  sigset_t before_;
};

}  // namespace arcspan::linux_host
