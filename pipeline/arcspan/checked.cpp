// SPDX-License-Identifier: MIT
#include <arcspan/checked.hpp>

#if defined(ARCSPAN_CHECKED) && ARCSPAN_CHECKED && __STDC_HOSTED__

#include <cstdio>
#include <cstdlib>

namespace arcspan {

ARCSPAN_REPLACEABLE void on_misuse(const char* cause) {
  std::fprintf(stderr, "arcspan: misuse: %s\n", cause);
  std::abort();
}

}  // namespace arcspan

#endif
