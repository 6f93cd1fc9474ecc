// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace arcspan::tools {

/// A one-line progress bar on standard error. It shows nothing unless standard error is a terminal, and
/// nothing for work that is done within a quarter of a second.
class Progress {
 public:
  /// `what` is a short label, `total` the number of steps; 0 means that their number is not known.
  Progress(std::string what, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Wipes the line.
  ~Progress();

  /// `done` of the steps are done.
  void show(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::size_t total_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point next_;
};

/// The text of the bar: `[#####.....]  50 %`. `done` beyond `total` counts as done.
[[nodiscard]] std::string progress_bar(std::size_t done, std::size_t total, std::size_t columns);

}  // namespace arcspan::tools
