// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/model.hpp>

#include <array>
#include <vector>

namespace arcspan::tools {

/// The colours of a triangle's corners, display values 0...1.
struct TriangleColour {
  bool known = false;
  std::array<Vec3, 3> corners{};
};

/// Gives every triangle that has colours the mean of those of its corners, in place of its material's: its
/// part is divided by colour, into 256 colours of the model at most. `colours` has an entry for each
/// triangle. Adds a warning if colours differ within triangles, or if there were more than 256.
void apply_colours(RawModel& model, const std::vector<TriangleColour>& colours);

}  // namespace arcspan::tools
