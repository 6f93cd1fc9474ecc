// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/mesh/plain/mesh_data.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace arcspan::tools {

/// Triangles of `mesh` with the vertices that they use, which stay in their order.
[[nodiscard]] MeshData subset(const MeshData& mesh, std::span<const std::array<std::uint32_t, 3>> triangles);

/// `mesh` in pieces of at most `most_vertices`, which are 3 or more; triangles stay in their order.
[[nodiscard]] std::vector<MeshData> in_pieces(const MeshData& mesh, std::size_t most_vertices);

}  // namespace arcspan::tools
