// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace arcspan::tools {

/// `text` as one line for a terminal: control characters (C0, DEL, C1) and bytes that are not UTF-8 are
/// written as escapes, \n, \t or \x1b. Names of files and arguments may hold any bytes.
[[nodiscard]] std::string printable(std::string_view text);

/// Prints `arcspan: TEXT` on standard error as one printable line of at most 300 characters: what is longer
/// is shown without its middle.
void print_message(std::string_view text);

}  // namespace arcspan::tools
