// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/temporaries.hpp>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Refuses the files of a command before it does any work. Throws Failure if two results are one file, if a
/// result is an input, if a result is a directory, or if the folder of a result does not exist. Devices and
/// pipes may be given twice. Empty names are skipped; names of inputs that are no files (`sphere:32x16`)
/// match nothing.
void check_results(const std::vector<std::filesystem::path>& results,
                   const std::vector<std::filesystem::path>& inputs);

struct ResultFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Writes all results of a command or none. Each is written into a temporary beside its target; when all are
/// complete, they are renamed, so that a reader never sees half a file and a failure leaves everything as it
/// was before. Symbolic links are followed, and a file that is replaced keeps its permissions. Standard
/// output, and targets that are no regular files (a terminal, a pipe), are written directly, before any is
/// renamed. `summary` is printed between the two, on report_stream(): what a user reads has happened. Throws
/// Failure, including if a result would replace a file that was_read(): models refer to files that only their
/// loaders know.
void write_results(const std::vector<ResultFile>& results, const std::string& summary = {});

/// A complete file or folder under a temporary name.
struct FilePlacement {
  Removal& temporary;
  std::filesystem::path target;
  std::filesystem::path subject;  ///< the target as the user named it, for messages
};

/// Prints a command's summary and then renames all temporaries to their targets or none; existing files are
/// replaced. Throws Failure, also if the summary cannot be printed.
void place_all(const std::vector<FilePlacement>& placements, const std::string& summary, std::FILE* stream);

/// The path that a file written to `path` has when all symbolic links are followed, even if it does not
/// exist. Throws Failure for a circle of links.
[[nodiscard]] std::filesystem::path destination(const std::filesystem::path& path);

}  // namespace arcspan::tools
