// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/mesh/bounding_sphere.hpp>

#include <span>

namespace arcspan {

/// A sphere around all vertices of a part in a pose, in object units. `bounds` are those of the part
/// (StoredAnimation::bounds()), `joints` what pose_joints() has set for its skin. It holds for every pose
/// with morph weights that are 0...1, or as at rest or in the model's clips, because a vertex lies between
/// the places where its joints would take it, and is larger than necessary. Without bounds, or if a bound
/// names a joint that is not among `joints`, it contains all 16-bit positions. The time is linear in the
/// number of joints, with a root of 16 steps for each row.
[[nodiscard]] BoundingSphere posed_bound(std::span<const JointBound> bounds,
                                         std::span<const JointMatrix> joints);

}  // namespace arcspan
