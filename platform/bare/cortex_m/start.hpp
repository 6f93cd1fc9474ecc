// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::bare {

/// A word of the vector table: a handler, or the initial stack pointer in the first one.
union Vector {
  void (*handler)();
  std::uint32_t* stack;
};

}  // namespace arcspan::bare
