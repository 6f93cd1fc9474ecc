// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/animation_binary.hpp>
#include <arcspan/numbers/fixed_formats.hpp>

#include <cstdint>

namespace arcspan {

/// From the space of a node to that of its object, or to its parent's: row i gives coordinate i as the sum of
/// entries[i] times the point, plus offset[i]. Entries have 24 fraction bits and are saturated at 64, offsets
/// at 2^22 object units. Not initialised: on a Cortex-M3 that would be a quarter of pose_joints().
struct NodeMatrix {
  std::int32_t entries[3][3];
  ObjectLength offset[3];
};

/// Translation, rotation and scale of a node relative to its parent at some time.
struct NodePose {
  std::int32_t translation[3];  ///< raw ObjectLength, below 2^30 in magnitude
  std::int32_t rotation[4];     ///< x, y, z, w of any length, below 2^15 in magnitude; all 0: no rotation
  std::int32_t scale[3];        ///< raw WorldLength, up to animation_binary::kLargestScale in magnitude
};

/// `node` at rest.
[[nodiscard]] NodePose rest_pose(const StoredNode& node);

/// A pose between two: of `b` there are `weight` 65536ths (0...65536). Rotations go the shorter way.
[[nodiscard]] NodePose blended(const NodePose& a, const NodePose& b, std::uint32_t weight);

/// Translation * rotation * scale. Entries of a rotation are within 2^-23 of the exact ones.
[[nodiscard]] NodeMatrix matrix_of(const NodePose& pose);

/// `inner` first, then `outer`. Entries and offsets are rounded down.
[[nodiscard]] NodeMatrix operator*(const NodeMatrix& outer, const NodeMatrix& inner);

/// The matrix of a joint, as it is stored.
[[nodiscard]] NodeMatrix matrix_of(const StoredJoint& joint);

}  // namespace arcspan
