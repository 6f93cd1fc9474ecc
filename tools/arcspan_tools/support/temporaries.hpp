// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <csignal>
#include <filesystem>
#include <string>

namespace arcspan::tools {

/// From now on SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM and SIGXCPU remove the temporaries of this process
/// before they end it as they would without this. Signals that are ignored (nohup) stay ignored.
void remove_temporaries_at_signals();

/// For a forked child: the signals have their default actions again, and the temporaries are its parent's.
void leave_temporaries_to_parent();

/// Holds the signals of remove_temporaries_at_signals() back from this thread as long as it exists.
class SignalPause {
 public:
  SignalPause();
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;
  ~SignalPause();

 private:
  sigset_t before_{};
};

/// A path that is removed when this object goes or when a signal ends the process: a file, or a folder that
/// is empty by then. Later ones are removed before earlier ones. For programs that create temporaries in one
/// thread.
class Removal {
 public:
  explicit Removal(const std::string& path);
  Removal(const Removal&) = delete;
  Removal& operator=(const Removal&) = delete;
  ~Removal();

  [[nodiscard]] const std::string& path() const;
  /// Leaves the path alone from now on, because it was renamed.
  void cancel();

  /// In the list that a signal handler reads. Entries stay until the process ends.
  struct Entry;

 private:
  Entry* entry_;
};

/// The hidden name of temporaries in `folder`, with XXXXXX for mkstemp and mkdtemp. It is short, because the
/// name of the result may be as long as the file system allows.
[[nodiscard]] std::string temporary_pattern(const std::filesystem::path& folder);

}  // namespace arcspan::tools
