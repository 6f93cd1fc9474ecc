// SPDX-License-Identifier: MIT
#pragma once

namespace arcspan::bare {

/// Exit statuses of programs that did not get to return one.
inline constexpr int kExitFault = 70;
inline constexpr int kExitStackOverflow = 71;

/// What a family's reset code does as soon as there is a stack: sets up memory, runs main(), checks the stack
/// and leaves with main()'s value.
[[noreturn]] void run();

}  // namespace arcspan::bare
