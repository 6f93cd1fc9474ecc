// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Instructions that `command` (a program and its arguments, which draws one picture) spends drawing, that is
/// in functions named draw_into: counted by valgrind's callgrind. Nothing if there is no valgrind. Throws
/// Failure if valgrind or the program fails.
[[nodiscard]] std::optional<std::uint64_t> drawing_instructions(const std::vector<std::string>& command);

}  // namespace arcspan::tools
