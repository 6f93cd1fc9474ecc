// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {

/// One option as a shell completes it.
struct CompletedOption {
  std::string long_name;   ///< with dashes; empty if there is none
  std::string short_name;  ///< with a dash; empty if there is none
  std::string help;        ///< one line
  bool takes_value = false;
  std::vector<std::string> choices;  ///< of the value; empty: a file, or anything
};

struct CompletedCommand {
  std::string name;
  std::string help;
  std::vector<CompletedOption> options;
  std::vector<std::string> words;  ///< that may stand without an option, beside files
};

/// Every subcommand of `app` with its options, as the parser knows them, so that completion cannot lag
/// behind.
[[nodiscard]] std::vector<CompletedCommand> completed_commands(const CLI::App& app);

/// Scripts for the shells' completion of the command `program`.
[[nodiscard]] std::string bash_completion(const std::string& program,
                                          const std::vector<CompletedCommand>& commands);
[[nodiscard]] std::string zsh_completion(const std::string& program,
                                         const std::vector<CompletedCommand>& commands);
[[nodiscard]] std::string fish_completion(const std::string& program,
                                          const std::vector<CompletedCommand>& commands);

}  // namespace arcspan::tools
