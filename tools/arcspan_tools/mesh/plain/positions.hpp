// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

#include <cstdint>
#include <vector>

namespace arcspan::tools {

/// The different positions of a mesh, without regard to normals: vertices on a crease share one.
struct Positions {
  std::vector<Vec3> points;        ///< each position once
  std::vector<std::uint32_t> ids;  ///< of every vertex, an index into `points`
};

[[nodiscard]] Positions positions_of(const MeshData& mesh);

}  // namespace arcspan::tools
