// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>

namespace arcspan {

/// A view of the measured figure, within a sphere of radius scenes::kRadius. It is compiled apart from the
/// programs that measure, so that it can be exchanged for another figure.
[[nodiscard]] bool make_character_mesh(MeshView& mesh);

}  // namespace arcspan
