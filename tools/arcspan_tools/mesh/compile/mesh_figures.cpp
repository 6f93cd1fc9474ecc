// SPDX-License-Identifier: MIT
#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/numbers/direction.hpp>

#include <arcspan_tools/mesh/compile/mesh_figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace arcspan::tools {
namespace {

void extend(MeshBounds& box, const ObjectPosition& p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

std::uint64_t squared_distance(const ObjectPosition& a, const ObjectPosition& b) {
  const auto square = [](std::int64_t c) { return static_cast<std::uint64_t>(c * c); };
  return square(a.x - b.x) + square(a.y - b.y) + square(a.z - b.z);
}

}  // namespace

MeshFigures figures_of(const FixedMesh& mesh) {
  MeshFigures found;
  found.bounds = {mesh.positions[0], mesh.positions[0]};
  for (const ObjectPosition& p : mesh.positions) extend(found.bounds, p);
  std::vector<Normal> normals;
  normals.reserve(mesh.normals.size());
  for (const PackedNormal& n : mesh.normals) normals.push_back(to_normal(unpack_normal(n)));
  std::uint32_t widest = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Normal& a = normals[mesh.indices[i]];
    const Normal& b = normals[mesh.indices[i + 1]];
    const Normal& c = normals[mesh.indices[i + 2]];
    const std::uint32_t chord = std::max({squared_chord(a, b), squared_chord(b, c), squared_chord(c, a)});
    widest = std::max(widest, chord);
    if (chord > kWidestBounded) ++found.wide_triangles;
  }
  const double half_chord = std::min(std::sqrt(std::ldexp(double(widest), -28)) / 2, 1.0);
  found.widest_angle_degrees = 2 * std::asin(half_chord) * 180 / std::numbers::pi;
  return found;
}

MeshFigures figures_of(const FixedModel& model) {
  MeshFigures all = figures_of(model.meshes[0]);
  for (std::size_t i = 1; i < model.meshes.size(); ++i) {
    const MeshFigures one = figures_of(model.meshes[i]);
    extend(all.bounds, one.bounds.low);
    extend(all.bounds, one.bounds.high);
    all.widest_angle_degrees = std::max(all.widest_angle_degrees, one.widest_angle_degrees);
    all.wide_triangles += one.wide_triangles;
  }
  return all;
}

BoundingSphere sphere_of(FixedMeshes meshes) {
  MeshBounds box{meshes[0].positions[0], meshes[0].positions[0]};
  for (const FixedMesh& mesh : meshes) {
    for (const ObjectPosition& p : mesh.positions) extend(box, p);
  }
  const auto middle = [](int low, int high) { return static_cast<std::int16_t>((low + high) >> 1); };
  BoundingSphere sphere{
      {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y), middle(box.low.z, box.high.z)}, 0};
  std::uint64_t farthest = 0;
  for (const FixedMesh& mesh : meshes) {
    for (const ObjectPosition& p : mesh.positions)
      farthest = std::max(farthest, squared_distance(p, sphere.middle));
  }
  if (farthest != 0) sphere.radius = static_cast<std::uint16_t>(wide_integer_root(farthest - 1) + 1);
  return sphere;
}

bool fits_indices8(std::size_t vertices) { return vertices <= 256; }

std::size_t array_bytes(std::size_t vertices, std::size_t triangles) {
  return 10 * vertices + triangles * (fits_indices8(vertices) ? 3 : 6);
}

}  // namespace arcspan::tools
