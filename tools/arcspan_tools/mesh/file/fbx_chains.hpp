// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/scene.h>

#include <map>

namespace arcspan::tools {

/// What joins a node of the loader library with the nodes above it that the library made of one node.
struct JoinedChain {
  aiMatrix4x4 place{};   ///< of the node, in place of its own
  aiQuaternion after{};  ///< to multiply its rotation keys by
};

/// The library makes a chain of nodes of a node of FBX that has a rotation before or after its own. But where
/// the node has no pivot, it gives keys of the whole chain to the last node, which the others would move once
/// more. Returns what puts such chains into their last nodes.
[[nodiscard]] std::map<const aiNode*, JoinedChain> joined_chains(const aiScene& scene);

/// The transform of FBX that moves the meshes of a node, and not its children. The library leaves it out of
/// the joints of skins.
[[nodiscard]] aiMatrix4x4 geometric_transform(const aiNode& node);

}  // namespace arcspan::tools
