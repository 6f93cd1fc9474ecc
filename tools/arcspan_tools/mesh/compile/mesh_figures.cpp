// SPDX-License-Identifier: MIT
#include <arcspan/lighting/triangle_light.hpp>
#include <arcspan/numbers/direction.hpp>

#include <arcspan_tools/mesh/compile/mesh_figures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace arcspan::tools {

MeshFigures figures_of(const FixedMesh& mesh) {
  MeshFigures found;
  found.bounds = {mesh.positions[0], mesh.positions[0]};
  for (const ObjectPosition& p : mesh.positions) {
    ObjectPosition& low = found.bounds.low;
    ObjectPosition& high = found.bounds.high;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
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
    ObjectPosition& low = all.bounds.low;
    ObjectPosition& high = all.bounds.high;
    const MeshBounds& b = one.bounds;
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    all.widest_angle_degrees = std::max(all.widest_angle_degrees, one.widest_angle_degrees);
    all.wide_triangles += one.wide_triangles;
  }
  return all;
}

bool fits_indices8(std::size_t vertices) { return vertices <= 256; }

std::size_t array_bytes(std::size_t vertices, std::size_t triangles) {
  return 10 * vertices + triangles * (fits_indices8(vertices) ? 3 : 6);
}

}  // namespace arcspan::tools
