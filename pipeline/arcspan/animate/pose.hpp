// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/clip_player.hpp>
#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/animate/stored_animation.hpp>
#include <arcspan/status.hpp>

#include <cstdint>
#include <span>

namespace arcspan {

/// Sets the matrices of all nodes, each from its own space to that of the object, at a moment of one or two
/// clips. Nodes that a clip does not move are at rest. `nodes` is the caller's memory, 48 bytes per node;
/// animation.nodes().size() of them are set. Two clips of the same animation may be blended; a clip of
/// another must not be given. Returns:
///
///   kOk
///   kBufferTooSmall   `nodes` is too short; nothing is changed
[[nodiscard]] Status pose_nodes(const StoredAnimation& animation, const ClipBlend& blend,
                                std::span<NodeMatrix> nodes);

/// Sets what the joints of a skin do to vertices, from the matrices of all nodes. `skin` is one of the
/// animation's. `joints` is the caller's memory, 48 bytes per joint; skin.size() of them are set. Returns:
///
///   kOk
///   kBufferTooSmall    `joints` is too short; nothing is changed
///   kIndexOutOfRange   `nodes` are not all those of the animation; some of `joints` may be set
[[nodiscard]] Status pose_joints(std::span<const StoredJoint> skin, std::span<const NodeMatrix> nodes,
                                 std::span<JointMatrix> joints);

/// Sets the weights of the morph targets of a part, 12 fraction bits. `weights` is the caller's memory, 2
/// bytes per target; as many as the part has targets are set. Returns:
///
///   kOk               also if the part has no targets
///   kBufferTooSmall   `weights` is too short; nothing is changed
[[nodiscard]] Status pose_morph(const StoredAnimation& animation, std::size_t part, const ClipBlend& blend,
                                std::span<std::int16_t> weights);

}  // namespace arcspan
