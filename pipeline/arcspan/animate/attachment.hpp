// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/animate/node_matrix.hpp>
#include <arcspan/vertex/placement.hpp>

namespace arcspan {

/// The placement of an object that a character holds: its origin and axes are those of a node. `body` is the
/// character's placement, `node` the node's matrix as pose_nodes() sets it. Both objects have the same unit.
/// Scales of the node do not count, nor do mirrors: the axes are made unit vectors at right angles, of which
/// x keeps its direction. A node of scale 0 does not turn the object. Translations are saturated.
[[nodiscard]] Placement attached(const Placement& body, const NodeMatrix& node);

}  // namespace arcspan
