// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/gltf/affine.hpp>
#include <arcspan_tools/mesh/gltf/gltf_file.hpp>

#include <map>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Transforms of nodes to the scene, by place.
using NodeTransforms = std::map<std::string, Affine>;

/// The transforms of a skin's joints as the nodes of the file stand: that of the joint's node times its
/// inverse bind matrix. `id` refers to the skin. Throws a Failure that names the place.
[[nodiscard]] std::vector<Affine> read_joints(GltfFile& file, const JsonView& id,
                                              const NodeTransforms& nodes);

/// The transform of each of so many vertices of a primitive: the sum of its joints' transforms by its
/// weights, which are divided by their sum. An empty list if the attributes name no joints.
[[nodiscard]] std::vector<Affine> blended_joints(GltfFile& file, const JsonView& attributes,
                                                 const std::vector<Affine>& joints, std::size_t vertices);

}  // namespace arcspan::tools
