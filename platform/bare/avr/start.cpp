// SPDX-License-Identifier: MIT
// From avr-libc's start-up code, which has set up stack, .data and .bss (its manual, "Memory Sections"), to
// run().
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/run.hpp>

extern "C" {

[[noreturn, gnu::used]] void arcspan_run() { arcspan::bare::run(); }

/// Lies where the start-up code passes through just before it would call main().
[[gnu::naked, gnu::used, gnu::section(".init8")]] void arcspan_reset() { __asm volatile("jmp arcspan_run"); }

/// Named by the start-up code, for a main() that returns to it.
[[noreturn]] void exit(int status) { arcspan::bare::leave(status); }

/// What the compiler makes of a trap.
[[noreturn]] void abort() { arcspan::bare::leave(arcspan::bare::kExitFault); }
}
