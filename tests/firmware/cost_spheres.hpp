// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>

namespace arcspan {

/// The spheres of the measured scene, by segments and rings.
enum class SphereFineness { k8x4, k16x8, k32x16, k64x32 };

/// A sphere with the planes of its triangles, without planes, and without triangles.
struct SphereMeshes {
  MeshView planed;
  MeshView plain;
  MeshView vertices;
};

/// Views of constants. They are compiled once for all programs that measure, because the compiler works for a
/// second on them. Returns false if a view refuses its sphere.
[[nodiscard]] bool make_sphere_meshes(SphereFineness fineness, SphereMeshes& meshes);

}  // namespace arcspan
