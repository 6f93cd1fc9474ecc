// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

namespace arcspan::tools {

/// `box`, which holds `model` in all poses, enlarged by the curves that arcspan::CurvedOutlines may find over
/// any of its edges at rest, and by what rounding may move these. A model with a rig, whose joints may turn a
/// curve to any side, gets room for its highest curve on all sides.
[[nodiscard]] Box with_curves(const Box& box, const Model& model);

}  // namespace arcspan::tools
