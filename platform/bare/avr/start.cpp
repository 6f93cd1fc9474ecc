// SPDX-License-Identifier: MIT
// Entry from avr-libc's start-up code, which has set up stack, .data and .bss (its manual, "Memory
// Sections").
#include <arcspan/bare/board.hpp>
#include <arcspan/bare/run.hpp>

extern "C" {

[[noreturn, gnu::used]] void arcspan_run() { arcspan::bare::run(); }

/// The start-up code runs through section .init8 just before it would call main().
[[gnu::naked, gnu::used, gnu::section(".init8")]] void arcspan_reset() { __asm volatile("jmp arcspan_run"); }

/// The start-up code refers to it for a main() that returns.
[[noreturn]] void exit(int status) { arcspan::bare::leave(status); }

/// The compiler calls it for a trap.
[[noreturn]] void abort() { arcspan::bare::leave(arcspan::bare::kExitFault); }
}
