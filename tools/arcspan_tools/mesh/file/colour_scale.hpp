// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <optional>
#include <vector>

namespace arcspan::tools {

/// Vertex colours as display values 0...1. Those of OBJ and of PLY with floats are 0...1 already, or 0...255
/// in the files of some programs: if any channel is above 1, all are divided by 255. What is outside then is
/// clamped. An empty list if there is no colour at all.
[[nodiscard]] std::vector<std::optional<Vec3>> scaled_colours(std::vector<std::optional<Vec3>> colours);

}  // namespace arcspan::tools
