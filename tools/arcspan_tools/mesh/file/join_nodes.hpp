// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/rig.hpp>

#include <cstddef>
#include <vector>

namespace arcspan::tools {

/// The loader library splits the transform of an FBX node into a chain of nodes, one for each pivot and
/// rotation. Joins each of these with the next one, its only child, where the product is a translation, a
/// rotation and a scale in every frame. Nodes in `kept` are left as they are. Returns the new number of each
/// node; one that is gone has that of its child.
[[nodiscard]] std::vector<std::size_t> join_pivot_nodes(Rig& rig, const std::vector<bool>& kept);

}  // namespace arcspan::tools
