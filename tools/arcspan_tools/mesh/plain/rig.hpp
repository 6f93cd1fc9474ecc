// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/clip.hpp>
#include <arcspan_tools/mesh/plain/node_transform.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Most joints that move a vertex; of more, those with the largest weights are kept.
inline constexpr std::size_t kMostWeights = 4;
/// Most morph targets of a mesh.
inline constexpr std::size_t kMostMorphTargets = 256;

struct RigNode {
  std::string name{};
  std::optional<std::size_t> parent{};  ///< an earlier node
  NodeTransform rest{};                 ///< where the file puts it, and no clip moves it
  std::optional<Affine> matrix{};       ///< in place of `rest`, of a node that no clip moves
};

struct RigSkin {
  std::string name{};
  std::vector<std::size_t> joints{};   ///< nodes
  std::vector<Affine> inverse_bind{};  ///< of each joint: from the space of the mesh to that of the joint
};

/// A mesh at a node.
struct RigInstance {
  std::size_t node = 0;
  std::optional<std::size_t> skin{};    ///< without one, the node moves the mesh
  std::vector<double> morph_weights{};  ///< of its morph targets, at rest
};

/// What a morph target adds to a vertex.
struct MorphDelta {
  Vec3 position{};
  Vec3 normal{};

  friend bool operator==(const MorphDelta&, const MorphDelta&) = default;
};

/// A vertex in the space of its mesh, and what moves it.
struct RigVertex {
  std::size_t instance = 0;
  Vec3 position{};
  Vec3 normal{};                                   ///< zero if the file gives none
  std::array<std::size_t, kMostWeights> joints{};  ///< of the instance's skin
  std::array<double, kMostWeights> weights{};      ///< the largest first; their sum is 1, without a skin 0
  std::vector<MorphDelta> deltas{};                ///< of each morph target of the instance

  friend bool operator==(const RigVertex&, const RigVertex&) = default;
};

/// What moves the vertices of a model: a tree of nodes, skins, morph targets and clips, as a file states
/// them.
struct Rig {
  std::vector<RigNode> nodes{};  ///< parents before their children
  std::vector<RigSkin> skins{};
  std::vector<RigInstance> instances{};
  std::vector<RigVertex> vertices{};
  std::vector<RigClip> clips{};
};

/// Whether one affine map moves both vertices in every pose: they follow the same joints and morph targets
/// alike.
[[nodiscard]] bool move_alike(const RigVertex& a, const RigVertex& b);

/// Whether a pose can give an area to a triangle that has none where its vertices are stored: they move
/// differently, and no two of them are one point. `joined[i]`: corners i and (i + 1) % 3 are stored at one
/// position.
[[nodiscard]] bool can_open(const Rig& rig, const std::array<std::uint32_t, 3>& vertices,
                            const std::array<bool, 3>& joined);

/// For each node, whether vertices follow it.
[[nodiscard]] std::vector<bool> followed_nodes(const Rig& rig);

/// For each node, whether a clip moves it or one of its ancestors.
[[nodiscard]] std::vector<bool> moved_nodes(const Rig& rig);

/// Replaces the matrix of a node that a clip moves by a translation, a rotation and a scale. Returns why that
/// is not possible, or nothing.
[[nodiscard]] std::optional<std::string> split_matrix(RigNode& node);

}  // namespace arcspan::tools
