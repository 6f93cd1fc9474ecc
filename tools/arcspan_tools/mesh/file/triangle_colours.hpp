// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

namespace arcspan::tools {

/// Moves RawModel::colours into meshes and looks. Where colours are kept, the triangles of a look that have
/// colours become a look of their own, white, whose corners have colours; but only if they differ within one
/// of its triangles. Elsewhere every triangle gets the mean of its corners, in place of its material's
/// colour: its part is divided by colour, into 256 colours of the model at most. Adds a warning if means are
/// taken of different colours, or if there were more than 256.
void apply_colours(RawModel& model, VertexColours choice);

}  // namespace arcspan::tools
