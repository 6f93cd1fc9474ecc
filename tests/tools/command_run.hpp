// SPDX-License-Identifier: MIT
#pragma once

#include <sys/wait.h>
#include <tests/tools/temporary_folder.hpp>

#include <cstdlib>
#include <string>

namespace arcspan::test {

struct CommandRun {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs the built `arcspan` with `arguments` (words for the shell), in the environment that `before` makes.
[[nodiscard]] inline CommandRun run(const std::string& arguments, const std::string& before = "") {
  const TemporaryFolder folder;
  const std::string line = before + std::string(ARCSPAN_COMMAND) + " " + arguments + " >" + (folder / "out") +
                           " 2>" + (folder / "err") + " </dev/null";
  const int ended = std::system(line.c_str());
  return {WIFEXITED(ended) ? WEXITSTATUS(ended) : -1, contents(folder / "out"), contents(folder / "err")};
}

}  // namespace arcspan::test
