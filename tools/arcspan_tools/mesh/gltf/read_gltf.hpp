// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/file/side_files.hpp>
#include <arcspan_tools/mesh/plain/model.hpp>

#include <string>
#include <string_view>

namespace arcspan::tools {

/// Reads the scene of a glTF file: the meshes of its nodes where their transforms put them, with their
/// materials and vertex colours. What moves them in a file of version 2.0 (skins, morph targets, animations
/// of nodes) is the model's rig. Things that are not drawn get a warning. Throws a Failure that names the
/// place in the file.
[[nodiscard]] RawModel read_gltf(std::string_view bytes, const std::string& subject, const SideFiles& files);

}  // namespace arcspan::tools
