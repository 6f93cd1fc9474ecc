// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/progress.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace arcspan::tools {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 250ms;
constexpr auto kRedraw = 50ms;
constexpr std::size_t kColumns = 40;

}  // namespace

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + kPatience) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::size_t done) {
  if (!terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kRedraw;
  drawn_ = true;
  if (total_ == 0) {
    std::fprintf(stderr, "\r%s ... %zu", what_.c_str(), done);
  } else {
    std::fprintf(stderr, "\r%s %s", what_.c_str(), progress_bar(done, total_, kColumns).c_str());
  }
  std::fflush(stderr);
}

std::string progress_bar(std::size_t done, std::size_t total, std::size_t columns) {
  const std::size_t capped = std::min(done, total);
  const std::size_t filled = total == 0 ? columns : columns * capped / total;
  const std::size_t percent = total == 0 ? 100 : 100 * capped / total;
  const std::string number = std::to_string(percent);
  return "[" + std::string(filled, '#') + std::string(columns - filled, '.') + "] " +
         std::string(3 - number.size(), ' ') + number + " %";
}

}  // namespace arcspan::tools
