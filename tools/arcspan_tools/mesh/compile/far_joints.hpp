// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <string>

namespace arcspan::tools {

/// Throws a Failure about `subject` that names a joint if the pipeline's sums wrap for a vertex of several
/// joints, at rest, at a key of a clip or in the middle of two: because one joint alone takes it too far from
/// the model or from where another takes it (JointMatrix::kFarthest). `model` must have a rig.
void check_joints_are_near(const FixedModel& model, const std::string& subject);

}  // namespace arcspan::tools
