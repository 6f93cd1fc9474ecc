// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/file/load.hpp>
#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/support/output_file.hpp>

#include <algorithm>
#include <filesystem>

namespace arcspan::tools {
namespace {

/// Whether a path stays within the folder that it is relative to.
bool stays_inside(const std::filesystem::path& path) {
  const bool has_drive = path.native().size() > 1 && path.native()[1] == ':';
  return !path.empty() && path.is_relative() && !has_drive &&
         std::find(path.begin(), path.end(), "..") == path.end();
}

}  // namespace

SideFiles side_files_of(const std::string& model) {
  const std::filesystem::path folder = std::filesystem::path(model).parent_path();
  return [folder](std::string name) -> std::optional<ReferredFile> {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path = folder / name;
    std::error_code failed;
    if (!stays_inside(name) || !std::filesystem::is_regular_file(path, failed)) return std::nullopt;
    return ReferredFile{path.string(), read_whole_file(path.string(), kMostFileBytes)};
  };
}

SideFiles no_side_files() {
  return [](const std::string&) { return std::optional<ReferredFile>(); };
}

}  // namespace arcspan::tools
