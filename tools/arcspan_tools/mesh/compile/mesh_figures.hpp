// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>

#include <cstddef>

namespace arcspan::tools {

/// The figures of a mesh that matter to firmware.
struct MeshFigures {
  MeshBounds bounds;
  double widest_angle_degrees = 0;  ///< between two normals of one triangle
  std::size_t wide_triangles = 0;   ///< with normals more than 60 degrees apart
};

/// `mesh` must have a vertex.
[[nodiscard]] MeshFigures figures_of(const FixedMesh& mesh);

/// Those of all parts together.
[[nodiscard]] MeshFigures figures_of(const FixedModel& model);

/// The smallest sphere around the middle of the box of all meshes; of one mesh bounding_sphere().
[[nodiscard]] BoundingSphere sphere_of(FixedMeshes meshes);

/// Whether the mesh's indices fit 8 bits.
[[nodiscard]] bool fits_indices8(std::size_t vertices);

/// Bytes of the three arrays: 10 a vertex, 3 or 6 a triangle.
[[nodiscard]] std::size_t array_bytes(std::size_t vertices, std::size_t triangles);

}  // namespace arcspan::tools
