// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/temporaries.hpp>
#include <unistd.h>

namespace arcspan::tools {

struct Removal::Entry {
  std::string path;
  Entry* earlier;
  std::atomic<bool> wanted{true};
};

namespace {

constexpr int kEndingSignals[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU};

// A signal handler may use lock-free atomics and nothing else of this library.
std::atomic<Removal::Entry*> newest{nullptr};
static_assert(std::atomic<Removal::Entry*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

sigset_t ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kEndingSignals) sigaddset(&set, signal);
  return set;
}

// unlink() and rmdir() are async-signal-safe.
void remove_now(const char* path) {
  if (::unlink(path) != 0) (void)::rmdir(path);
}

// Ends the process by the same signal, so that a shell sees it. SA_RESETHAND has restored the default action.
extern "C" void arcspan_remove_temporaries_and_end(int signal) {
  for (const Removal::Entry* entry = newest.load(); entry != nullptr; entry = entry->earlier) {
    if (entry->wanted.load()) remove_now(entry->path.c_str());
  }
  sigset_t this_one;
  sigemptyset(&this_one);
  sigaddset(&this_one, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &this_one, nullptr);
  (void)::raise(signal);
}

}  // namespace

void remove_temporaries_at_signals() {
  struct sigaction action {};
  action.sa_handler = &arcspan_remove_temporaries_and_end;
  action.sa_mask = ending_signals();
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kEndingSignals) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_DFL) {
      ::sigaction(signal, &action, nullptr);
    }
  }
}

void leave_temporaries_to_parent() {
  newest.store(nullptr);
  for (const int signal : kEndingSignals) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler != SIG_IGN) {
      (void)std::signal(signal, SIG_DFL);
    }
  }
}

SignalPause::SignalPause() {
  const sigset_t set = ending_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, &before_);
}

SignalPause::~SignalPause() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

Removal::Removal(const std::string& path) : entry_(new Entry{path, newest.load()}) { newest.store(entry_); }

Removal::~Removal() {
  if (!entry_->wanted.load()) return;
  remove_now(entry_->path.c_str());
  cancel();
}

const std::string& Removal::path() const { return entry_->path; }

void Removal::cancel() { entry_->wanted.store(false); }

std::string temporary_pattern(const std::filesystem::path& folder) {
  return (folder / ".arcspan-XXXXXX").string();
}

}  // namespace arcspan::tools
