// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/text_lines.hpp>

#include <functional>
#include <optional>
#include <string>

namespace arcspan::tools {

/// A file that a model file refers to.
struct ReferredFile {
  std::string subject;  ///< names it in messages
  std::string bytes;
};

/// Reads the file that a model file calls `name`; nothing if it cannot be read.
using SideFiles = std::function<std::optional<ReferredFile>(const std::string& name)>;

/// Reads from the folder of the model file and below only: names that lead out of it, and absolute ones, give
/// nothing. Backslashes count as slashes. If there is no file of a name, one is read whose name differs in
/// upper and lower case only.
[[nodiscard]] SideFiles side_files_of(const std::string& model);

/// The file that the first of these names stands for which there is.
[[nodiscard]] std::optional<ReferredFile> find_file(const SideFiles& files, const Readings& names);

/// Reads nothing.
[[nodiscard]] SideFiles no_side_files();

}  // namespace arcspan::tools
