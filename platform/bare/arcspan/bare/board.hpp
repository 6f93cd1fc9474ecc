// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The functions that a bare-metal program may call and that a board must define.
///
/// A board is a folder under platform/ with `board.cmake` (core, emulator, sources), `memory.ld` (memory map
/// and stack size) and, if the common drivers do not fit, its own sources for the functions below.
namespace arcspan::bare {

/// Initialises clocks, console and counter. Called once before main(), after .data and .bss are set up.
void initialise_board();

/// Writes zero-terminated `text` to the console and blocks until it is sent. Not for interrupt handlers. With
/// semihosting and without a debugger, nothing happens.
void write(const char* text);

/// Ends the program. `status`, 0 ... 255, becomes the exit status of the emulator; 0 is success. Without a
/// debugger it loops forever.
[[noreturn]] void leave(int status);

/// A counter that runs from initialise_board() on. Its unit is the board's: processor cycles, timer ticks or
/// instructions (see the defining source), so compare differences on one board only. For exact instruction
/// counts use platform/qemu/instruction_count.c.
[[nodiscard]] std::uint64_t ticks();

}  // namespace arcspan::bare
