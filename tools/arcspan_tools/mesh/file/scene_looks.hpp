// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/import.hpp>
#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>

namespace arcspan::tools {

/// The model of a scene that import_mesh() has read, with the materials that it lists. `subject` names the
/// file in the Failure that is thrown for a damaged picture.
[[nodiscard]] RawModel scene_model(ImportedMesh mesh, const std::string& subject, const SideFiles& files);

}  // namespace arcspan::tools
