// SPDX-License-Identifier: MIT
#include <tests/firmware/cost_spheres.hpp>

#include <span>

namespace arcspan {

bool make_sphere_meshes(std::uint32_t segments, std::uint32_t rings, SphereMemory& memory,
                        SphereMeshes& meshes) {
  const std::size_t vertex_count = segments * (rings - 1) + 2;
  const std::size_t triangle_count = 2 * segments * (rings - 1);
  if (vertex_count > SphereMemory::kMostVertices || triangle_count > SphereMemory::kMostTriangles)
    return false;
  const bool is_new = segments != memory.segments || rings != memory.rings;
  if (is_new) scenes::set_sphere(segments, rings, memory.shape);
  memory.segments = segments;
  memory.rings = rings;

  const std::span positions = std::span(memory.shape.positions).first(vertex_count);
  const std::span normals = std::span(memory.shape.normals).first(vertex_count);
  const std::span<const std::uint16_t> indices = std::span(memory.shape.indices).first(3 * triangle_count);
  if (!ok(MeshView::make(positions, normals, indices, meshes.plain)) ||
      !ok(MeshView::make(positions, normals, indices.first(0), meshes.vertices))) {
    return false;
  }
  const std::span planes = std::span(memory.planes.planes).first(triangle_count);
  if (is_new && !ok(make_face_planes(meshes.plain, planes, memory.planes.scale))) return false;
  meshes.planed = meshes.plain;
  return ok(meshes.planed.attach(planes, memory.planes.scale));
}

}  // namespace arcspan
