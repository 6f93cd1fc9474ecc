// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace arcspan::test {

/// The number of random cases to try: ARCSPAN_TEST_SHARE percent of `cases`, 1 at least; all if it is unset.
/// For builds where every case is slow, because of sanitizers or because nothing is optimised.
[[nodiscard]] inline int share_of(int cases) {
  static const int percent = [] {
    const char* const share = std::getenv("ARCSPAN_TEST_SHARE");
    return share == nullptr ? 100 : std::atoi(share);
  }();
  if (percent < 1 || percent > 100 || cases < 1) return cases;
  return cases * percent < 100 ? 1 : cases * percent / 100;
}

/// The stride by which a loop over arguments takes as many as share_of() allows.
[[nodiscard]] inline int stride_of(int stride) { return stride * 100 / share_of(100); }

}  // namespace arcspan::test
