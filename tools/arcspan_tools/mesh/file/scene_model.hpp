// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>

namespace arcspan::tools {

/// The model of a scene that import_scene() has read, with the pictures of its materials and what moves it.
/// `subject` names the file in the Failure that it may throw.
[[nodiscard]] RawModel scene_model(const std::string& imported, const std::string& subject,
                                   const SideFiles& files);

}  // namespace arcspan::tools
