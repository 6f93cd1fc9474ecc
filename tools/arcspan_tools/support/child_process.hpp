// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/output_file.hpp>
#include <arcspan_tools/support/temporaries.hpp>
#include <sys/types.h>

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Forks. The kernel kills the child when this process ends, however it ends; signals have their default
/// actions in the child. Returns as fork() does. To be called in the thread that lives longest.
[[nodiscard]] pid_t fork_child();

/// Waits until a child has ended and returns its status as waitpid() gives it.
[[nodiscard]] int wait_for_child(pid_t child);

/// A folder with files of known names; all of it is removed with this object, and when a signal ends the
/// process.
class ScratchFolder {
 public:
  /// A hidden folder within `parent`. `subject` names it in the Failure that is thrown if there can be none.
  ScratchFolder(const std::filesystem::path& parent, const std::filesystem::path& subject);
  /// In the folder for temporary files that the user's TMPDIR names.
  ScratchFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The path of a file in it, which whoever has the path may create.
  [[nodiscard]] Removal& file(const std::string& name);
  /// The removal of the folder itself.
  [[nodiscard]] Removal& folder() { return *folder_; }

 private:
  std::filesystem::path path_;
  std::optional<Removal> folder_;
  std::deque<Removal> files_;  ///< after the folder, so that they are removed first
};

struct ChildEnd {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string error_text;
};

/// Runs a program (found along PATH) with the given arguments and standard input, and waits for it. Its
/// standard output is discarded, its standard error is returned. Nothing if there is no such program.
[[nodiscard]] std::optional<ChildEnd> run_child(const std::string& program,
                                                const std::vector<std::string>& arguments,
                                                const std::string& input = {});

}  // namespace arcspan::tools
