// SPDX-License-Identifier: MIT
#pragma once

#include <tests/frames/integer_shapes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// Memory of a sphere of at most 64 segments and 32 rings.
struct SphereMemory {
  static constexpr std::size_t kMostVertices = 64 * 31 + 2;
  static constexpr std::size_t kMostTriangles = 2 * 64 * 31;

  scenes::Shape<kMostVertices, kMostTriangles> shape;
  scenes::Planes<kMostTriangles> planes;
  std::uint32_t segments = 0;  ///< of the sphere that is held
  std::uint32_t rings = 0;
};

/// A sphere with the planes of its triangles, without planes, and without triangles.
struct SphereMeshes {
  MeshView planed;
  MeshView plain;
  MeshView vertices;
};

/// Makes views of a sphere in `memory`, in which it is made unless it is there already. Returns false if it
/// does not fit or a view refuses it. Compiled once for all programs that measure.
[[nodiscard]] bool make_sphere_meshes(std::uint32_t segments, std::uint32_t rings, SphereMemory& memory,
                                      SphereMeshes& meshes);

}  // namespace arcspan
