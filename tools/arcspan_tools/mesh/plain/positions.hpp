// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/support/vec3.hpp>

#include <cstdint>
#include <vector>

namespace arcspan::tools {

/// The different positions among the vertices of a mesh: vertices on a crease share one.
struct Positions {
  std::vector<Vec3> points;        ///< each position once
  std::vector<std::uint32_t> ids;  ///< of every vertex, an index into `points`
};

[[nodiscard]] Positions positions_of(const std::vector<Vec3>& vertices);

}  // namespace arcspan::tools
