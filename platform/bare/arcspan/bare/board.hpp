// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// What a program on a bare board can rely on, and what a board's folder has to supply.
///
/// A board is one folder under platform/ with `board.cmake` (core, emulator, sources), `memory.ld` (memory
/// map and stack size) and, where the common drivers do not fit, sources of its own for the functions below.
namespace arcspan::bare {

/// Brings the board from reset to where main() can run: clocks, console, counter. Called once, after .data
/// and .bss are set up and before main().
void initialise_board();

/// Writes zero-terminated `text` to the console and returns when it is out. Not for interrupt handlers.
void write(const char* text);

/// Ends the program; `status` 0 means success and becomes the exit status of the emulator (0...255). Does not
/// return on a board without a debugger either: it stays in a loop.
[[noreturn]] void leave(int status);

/// A counter that runs from initialise_board() on and never stops. Its unit differs from board to board (see
/// the source that defines it): processor cycles, timer ticks or instructions; only ratios of differences on
/// one board mean something. For exact instruction counts there is platform/qemu/instruction_count.c.
[[nodiscard]] std::uint64_t ticks();

}  // namespace arcspan::bare
