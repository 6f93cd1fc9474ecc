// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace arcspan::tools {

/// Milliseconds that the calling thread has had of a processor: what else the machine does is not in it.
[[nodiscard]] inline double processor_milliseconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace arcspan::tools
