// SPDX-License-Identifier: MIT
#include <arcspan/bare/mark.hpp>

// The asm statement and noipa keep the compiler from noticing that nothing happens and moving work across the
// call.
extern "C" [[gnu::noipa, gnu::noinline]] void arcspan_mark() { __asm volatile("" ::: "memory"); }
