// SPDX-License-Identifier: MIT
#include <arcspan/linux_host/signal_watch.hpp>

#include <cerrno>
#include <initializer_list>

namespace arcspan::linux_host {
namespace {

constexpr long kNanosecondsPerSecond = 1'000'000'000;

// Time from now to `until`; zero if it has passed.
timespec remaining(const timespec& until) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  timespec left{until.tv_sec - now.tv_sec, until.tv_nsec - now.tv_nsec};
  if (left.tv_nsec < 0) {
    left.tv_nsec += kNanosecondsPerSecond;
    --left.tv_sec;
  }
  return left.tv_sec < 0 ? timespec{} : left;
}

auto handler_of(int signal) {
  struct sigaction present {};
  ::sigaction(signal, nullptr, &present);
  return present.sa_handler;
}

}  // namespace

SignalWatch::SignalWatch() {
  sigemptyset(&watched_);
  // An ignored signal (nohup) is left out, because a blocked one would be reported.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    if (handler_of(signal) != SIG_IGN) sigaddset(&watched_, signal);
  }
  // Handled, these do not end the program.
  for (const int signal :
       {SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGXFSZ, SIGPOLL, SIGPWR, SIGSTKFLT}) {
    if (handler_of(signal) == SIG_DFL) sigaddset(&watched_, signal);
  }
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) {
    if (handler_of(signal) == SIG_DFL) sigaddset(&watched_, signal);
  }
  ::pthread_sigmask(SIG_BLOCK, &watched_, &before_);
}

SignalWatch::~SignalWatch() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

int SignalWatch::poll() { return wait_until({}); }

int SignalWatch::wait_until(const timespec& until) {
  while (true) {
    const timespec left = remaining(until);
    const int signal = ::sigtimedwait(&watched_, nullptr, &left);
    if (signal > 0) return signal;
    if (errno != EINTR) return 0;
  }
}

int SignalWatch::wait() {
  while (true) {
    const int signal = ::sigwaitinfo(&watched_, nullptr);
    if (signal > 0) return signal;
  }
}

}  // namespace arcspan::linux_host
