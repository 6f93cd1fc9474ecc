// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arcspan::bare {

/// Size of the stack in bytes (memory.ld).
[[nodiscard]] std::uint32_t stack_size();

/// Bytes of the stack that a program may use (memory.ld); the rest is in reserve. A program that has used
/// more when main() returns leaves with kExitStackOverflow.
[[nodiscard]] std::uint32_t stack_limit();

/// Fills the unused part of the stack, from the bottom to a little below the caller's frame, with a pattern.
void paint_stack();

/// Bytes between the top of the stack and the frame of the caller's callees.
[[nodiscard]] std::uint32_t stack_depth();

/// Bytes between the top of the stack and the deepest word written since paint_stack(). Equals stack_size()
/// if the pattern is gone down to the bottom.
[[nodiscard]] std::uint32_t deepest_stack();

}  // namespace arcspan::bare
