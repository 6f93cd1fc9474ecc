// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/rig.hpp>
#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Reads the clips of a scene of import_scene(). `morph_targets` returns how many morph targets the meshes of
/// a node have. A clip that is wrong is left out, with a warning. Splits the matrices of nodes with channels.
[[nodiscard]] std::vector<RigClip> scene_clips(const nlohmann::json& scene, std::vector<RigNode>& nodes,
                                               const std::function<std::size_t(std::size_t)>& morph_targets,
                                               std::vector<std::string>& warnings);

}  // namespace arcspan::tools
