// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/joint_matrix.hpp>
#include <arcspan/mesh/bounding_sphere.hpp>

#include <span>

namespace arcspan {

/// A sphere around all vertices of a part in a pose, in object units. `bounds` are those of the part
/// (StoredAnimation::bounds()), `joints` what pose_joints() has set for its skin. It holds for every pose
/// whose morph weights are in 0...1 or in the range of the rest and the clips, because a vertex lies between
/// the places where its joints alone would take it. So the sphere is larger than necessary. Without bounds,
/// or if a bound names a joint that is not among `joints` or that takes it as far as JointMatrix::kFarthest,
/// it contains all 16-bit positions. The time is linear in the number of `bounds`, with a root of 32 steps
/// for each row of a matrix.
[[nodiscard]] BoundingSphere posed_bound(std::span<const JointBound> bounds,
                                         std::span<const JointMatrix> joints);

}  // namespace arcspan
