// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

namespace CLI {
class App;
}

// Every file of this folder named NAME_command.cpp is the subcommand NAME and defines
//
//   void arcspan::tools::add_NAME_command(CLI::App& app);
//
// which adds it to `app` with a callback that runs it; the build makes the list of subcommands. A callback
// throws Failure if something is wrong, or ExitStatus to end with a status other than 0.

namespace arcspan::tools {

struct ExitStatus {
  int value = 0;
};

struct Subcommand {
  std::string_view name;
  void (*add)(CLI::App& app);
};

/// Every subcommand of this build (generated).
[[nodiscard]] std::span<const Subcommand> subcommands();

/// The whole program: parses, runs one subcommand, prints one line for a failure. Returns the exit status: 0,
/// 1 for what was wrong with files, 2 for wrong arguments.
[[nodiscard]] int run_command_line(int argc, const char* const* argv);

}  // namespace arcspan::tools
