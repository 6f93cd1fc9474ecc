// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/output_file.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// A folder that goes away with this object. Throws Failure if there can be none.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();

  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

struct ChildEnd {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string error_text;
};

/// Runs a program (found along PATH) with the given arguments and standard input, and waits for it. What it
/// prints goes nowhere, what it complains of is returned. Nothing if there is no such program.
[[nodiscard]] std::optional<ChildEnd> run_child(const std::string& program,
                                                const std::vector<std::string>& arguments,
                                                const std::string& input = {});

}  // namespace arcspan::tools
