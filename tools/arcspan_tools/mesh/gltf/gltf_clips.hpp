// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/accessor.hpp>
#include <arcspan_tools/mesh/gltf/gltf_nodes.hpp>

#include <functional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Reads the animations of a file of version 2.0, each as a clip; channels of nodes that are not in the
/// scene, and of what is no property of a node, are left out. `morph_targets` returns how many the mesh of a
/// node has. A clip without a name is called by its number: clip1. One that is wrong is left out, with a
/// warning that names the place.
[[nodiscard]] std::vector<RigClip> read_gltf_clips(
    GltfFile& file, GltfNodes& nodes, const std::function<std::size_t(std::size_t node)>& morph_targets,
    LeftOut& left_out, std::vector<std::string>& warnings);

}  // namespace arcspan::tools
