// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/rig.hpp>

#include <cstddef>
#include <vector>

namespace arcspan::tools {

/// The loader library splits the transform of an FBX node into a chain of nodes, one for each pivot and
/// rotation. Joins each of these with its only child, if their product is one translation, rotation and scale
/// and the keys of both, which must be linear, can become keys of the child. Nodes in `kept` are not removed.
/// Returns the new number of each node; a removed one has that of the node it was joined with.
[[nodiscard]] std::vector<std::size_t> join_pivot_nodes(Rig& rig, const std::vector<bool>& kept);

}  // namespace arcspan::tools
