// SPDX-License-Identifier: MIT
#include <arcspan/bare/mark.hpp>

// Without the asm statement and noipa the compiler would see an empty function and move work across the call.
extern "C" [[gnu::noipa, gnu::noinline]] void arcspan_mark() { __asm volatile("" ::: "memory"); }
