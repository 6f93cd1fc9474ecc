// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

namespace arcspan::tools {

/// `box`, which holds `model` in all poses, with the curves that arcspan::CurvedOutlines may find over its
/// edges: exactly those of a model that stands still. Around one that moves there is room for its highest
/// curve at rest on all sides.
[[nodiscard]] Box with_curves(const Box& box, const Model& model);

}  // namespace arcspan::tools
