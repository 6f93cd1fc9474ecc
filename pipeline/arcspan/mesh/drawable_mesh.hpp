// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>

#include <concepts>
#include <cstddef>

namespace arcspan {

/// A mesh that draw_mesh() draws. Two are of the library: MeshView, whose vertices lie in memory as they are
/// drawn, and SkinnedMesh, whose vertices follow joints. A program writes its own to move vertices in another
/// way, such as a waving flag (docs/animation.md).
///
/// - view(): the triangles, texture points and colours. Its positions and normals are not drawn, and neither
///   are its planes used, unless the mesh is a MeshView.
/// - position(i): where vertex i is, i < view().vertex_count().
/// - direction(i): its unit normal.
///
/// Both are asked for whenever a vertex is needed, in any order, possibly several times in a picture, and
/// must give the same each time. They may be asked for by several cores at once.
template <class M>
concept DrawableMesh = requires(const M& mesh, std::size_t i) {
  { mesh.view() } -> std::same_as<const MeshView&>;
  { mesh.position(i) } -> std::convertible_to<ObjectPosition>;
  { mesh.direction(i) } -> std::same_as<Direction>;
};

static_assert(DrawableMesh<MeshView>);

}  // namespace arcspan
