// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/file/text_lines.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <algorithm>
#include <filesystem>

namespace arcspan::tools {
namespace {

/// Whether a path without `x/..` stays within the folder that it is relative to.
bool stays_inside(const std::filesystem::path& path) {
  const bool has_drive = path.native().size() > 1 && path.native()[1] == ':';
  return !path.empty() && path.is_relative() && !has_drive &&
         std::find(path.begin(), path.end(), "..") == path.end();
}

/// The regular file that `path` names. If there is none, the one whose name differs in upper and lower case
/// only, because old formats were written where that does not matter; the first in alphabetical order.
std::optional<std::filesystem::path> find_file(const std::filesystem::path& path) {
  std::error_code failed;
  if (std::filesystem::is_regular_file(path, failed)) return path;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::optional<std::filesystem::path> found;
  for (std::filesystem::directory_iterator at(folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::filesystem::path& other = at->path();
    std::error_code unreadable;
    if (same_letters(other.filename().string(), path.filename().string()) &&
        at->is_regular_file(unreadable) && (!found || other < *found)) {
      found = other;
    }
  }
  return found;
}

}  // namespace

SideFiles side_files_of(const std::string& model) {
  const std::filesystem::path folder = std::filesystem::path(model).parent_path();
  return [folder](std::string name) -> std::optional<ReferredFile> {
    std::replace(name.begin(), name.end(), '\\', '/');
    // Materials in a folder of their own write `../textures/a.png`, which is in the model's folder again.
    const std::filesystem::path inside = std::filesystem::path(name).lexically_normal();
    const std::optional<std::filesystem::path> file =
        stays_inside(inside) ? find_file(folder / inside) : std::nullopt;
    if (!file) return std::nullopt;
    return ReferredFile{file->string(), read_whole_file(*file, kMostFileBytes)};
  };
}

std::optional<ReferredFile> find_file(const SideFiles& files, const Readings& names) {
  for (const std::string& name : names) {
    if (std::optional<ReferredFile> file = files(name)) return file;
  }
  return std::nullopt;
}

SideFiles no_side_files() {
  return [](const std::string&) { return std::optional<ReferredFile>(); };
}

}  // namespace arcspan::tools
