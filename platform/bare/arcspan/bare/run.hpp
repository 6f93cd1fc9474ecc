// SPDX-License-Identifier: MIT
#pragma once

namespace arcspan::bare {

/// Exit statuses of programs that did not return from main(), or used too much stack.
inline constexpr int kExitFault = 70;
inline constexpr int kExitStackOverflow = 71;

/// Sets up memory, runs main(), checks the stack and leaves with main()'s value. The reset code of a
/// processor family calls it as soon as there is a stack.
[[noreturn]] void run();

}  // namespace arcspan::bare
