// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace arcspan::test {

/// Fewer triangles where every one is slow (sanitizers): ARCSPAN_TEST_SHARE percent of them.
[[nodiscard]] inline int share_of(int triangles) {
  const char* const share = std::getenv("ARCSPAN_TEST_SHARE");
  const int percent = share == nullptr ? 100 : std::atoi(share);
  return percent < 1 || percent > 100 ? triangles : triangles * percent / 100;
}

}  // namespace arcspan::test
