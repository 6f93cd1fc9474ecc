// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <ctime>

namespace arcspan::linux_host {

/// Blocks the signals that would end the program from outside: SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE,
/// SIGXCPU, and, unless the program handles them, SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXFSZ,
/// SIGPOLL, SIGPWR, SIGSTKFLT and the real-time ones, but not those of crashes, such as SIGABRT. The program
/// polls for them where it can stop and restore its devices. Ignored signals stay ignored. The destructor
/// restores the signal mask. For programs with one thread.
class SignalWatch {
 public:
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

  /// Returns and clears a pending signal, or 0. Does not block.
  [[nodiscard]] int poll();

  /// Blocks until a signal arrives and returns it, or 0 when CLOCK_MONOTONIC reaches `until`.
  [[nodiscard]] int wait_until(const timespec& until);

  /// Blocks until a signal arrives and returns it.
  [[nodiscard]] int wait();

 private:
  sigset_t watched_;
  sigset_t before_;
};

}  // namespace arcspan::linux_host
