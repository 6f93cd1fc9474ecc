// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <arcspan_tools/command/command.hpp>
#include <arcspan_tools/command/completion.hpp>

#include <cstdio>
#include <memory>

namespace arcspan::tools {
namespace {

void print_completion(const CLI::App& app, const std::string& shell) {
  const std::vector<CompletedCommand> commands = completed_commands(app);
  const auto script = shell == "bash"  ? &bash_completion
                      : shell == "zsh" ? &zsh_completion
                                       : &fish_completion;
  std::fputs(script(app.get_name(), commands).c_str(), stdout);
}

}  // namespace

void add_completion_command(CLI::App& app) {
  auto shell = std::make_shared<std::string>();
  CLI::App* completion =
      app.add_subcommand("completion", "Print a script that completes this command in a shell");
  completion->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->type_name("bash|zsh|fish")
      ->check([](const std::string& name) {
        const bool known = name == "bash" || name == "zsh" || name == "fish";
        return known ? "" : "expected bash, zsh or fish, not '" + name + "'";
      });
  completion->footer(
      "Examples:\n"
      "  source <(arcspan completion bash)              # in ~/.bashrc\n"
      "  source <(arcspan completion zsh)               # in ~/.zshrc, after compinit\n"
      "  arcspan completion fish | source               # in ~/.config/fish/config.fish");
  completion->callback([&app, shell] { print_completion(app, *shell); });
}

}  // namespace arcspan::tools
