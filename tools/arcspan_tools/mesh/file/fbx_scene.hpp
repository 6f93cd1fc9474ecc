// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/scene.h>

#include <map>

// Scenes of FBX files are loaded by the library Assimp. Here is what it leaves to its caller, and what its
// version 5.2 gets wrong.

namespace arcspan::tools {

/// The transform from the axes and the unit that an FBX file states to ours: y up, z to the viewer, metres.
[[nodiscard]] aiMatrix4x4 fbx_space(const aiScene& scene);

/// A node of an FBX file that the library has split into several, put together again.
struct JoinedNode {
  aiMatrix4x4 transform{};
  aiQuaternion after{};  ///< keys of its rotation are multiplied by it, on the right
};

/// The library splits a node "X" that has a rotation before or after its own (PreRotation, PostRotation) into
/// a chain of nodes "X_$AssimpFbx$_PreRotation"... above "X". If the chain has no pivot, keys of "X" hold
/// the transform of the whole chain, and the nodes above would apply theirs again. Returns, for each such
/// chain of which only "X" has keys, the whole transform for "X" and the identity for the nodes above.
[[nodiscard]] std::map<const aiNode*, JoinedNode> joined_fbx_nodes(const aiScene& scene);

/// The transform that moves the meshes of a node, and not its children (GeometricTranslation, -Rotation,
/// -Scaling). The library leaves it out of the offset matrices of bones.
[[nodiscard]] aiMatrix4x4 geometric_transform(const aiNode& node);

}  // namespace arcspan::tools
