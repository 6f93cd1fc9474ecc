// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::bare {

/// Bytes that memory.ld reserves for the stack.
[[nodiscard]] std::uint32_t stack_size();

/// Bytes of it that a program may use at its deepest, as memory.ld says; the rest is in reserve. A program
/// that returns from main() after having used more leaves with kExitStackOverflow.
[[nodiscard]] std::uint32_t stack_limit();

/// Fills the unused part of the stack, up to a little below the caller's frame, with a pattern.
void paint_stack();

/// Bytes between the top of the stack and the deepest word that was written since paint_stack(): the most
/// that was in use at any time, as far as it was written to. Equals stack_size() if the pattern is gone down
/// to the bottom.
[[nodiscard]] std::uint32_t deepest_stack();

}  // namespace arcspan::bare
