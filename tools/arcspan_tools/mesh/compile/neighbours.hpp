// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Light breaks visibly where the normals of two triangles differ by more at their common edge, in degrees.
inline constexpr double kOutlineCrease = 15;

/// Returns the bytes of arcspan::MeshNeighbours for a mesh: the triangles across all edges, by the positions
/// of their ends. An edge is a crease if at one of its ends the normals of both sides are more than `degrees`
/// apart or the vertex colours differ. Of several triangles at one edge each is joined with one that runs in
/// the opposite direction; those without a partner have a border there.
[[nodiscard]] std::vector<std::uint8_t> neighbours_of(const FixedMesh& mesh, double degrees = kOutlineCrease);

/// The same mesh with its neighbours; throws Failure about `subject` if the pipeline does not take it.
[[nodiscard]] FixedMesh with_neighbours(FixedMesh mesh, const std::string& subject);

/// with_neighbours() of each part.
[[nodiscard]] FixedModel with_neighbours(FixedModel model, const std::string& subject);

}  // namespace arcspan::tools
