// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <meshoptimizer.h>

#include <array>
#include <map>
#include <vector>

namespace arcspan::tools {
namespace {

/// Position, normal, texture point and colour.
using Vertex = std::array<std::int16_t, 10>;

bool has_area(const ObjectPosition& a, const ObjectPosition& b, const ObjectPosition& c) {
  const std::int64_t ux = b.x - a.x;
  const std::int64_t uy = b.y - a.y;
  const std::int64_t uz = b.z - a.z;
  const std::int64_t vx = c.x - a.x;
  const std::int64_t vy = c.y - a.y;
  const std::int64_t vz = c.z - a.z;
  return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
}

FixedMesh without_arrays(const FixedMesh& mesh) {
  FixedMesh out;
  out.unit = mesh.unit;
  out.centre = mesh.centre;
  out.texture_scale = mesh.texture_scale;
  return out;
}

std::vector<unsigned> wide_indices(const FixedMesh& mesh) {
  return {mesh.indices.begin(), mesh.indices.end()};
}

}  // namespace

FixedMesh compacted(const FixedMesh& mesh) {
  FixedMesh out = without_arrays(mesh);
  std::map<Vertex, std::uint16_t> known;
  const auto vertex = [&](std::size_t i) {
    const ObjectPosition& p = mesh.positions[i];
    const PackedNormal& n = mesh.normals[i];
    const bool textured = !mesh.texture_points.empty();
    const TexturePoint t = textured ? mesh.texture_points[i] : TexturePoint{};
    const auto next = static_cast<std::uint16_t>(out.positions.size());
    const bool coloured = !mesh.colours.empty();
    const Rgb8 c = coloured ? mesh.colours[i] : Rgb8{};
    const auto [at, is_new] =
        known.try_emplace(Vertex{p.x, p.y, p.z, n.u, n.v, t.u, t.v, c.r, c.g, c.b}, next);
    if (is_new) {
      out.positions.push_back(p);
      out.normals.push_back(n);
      if (textured) out.texture_points.push_back(t);
      if (coloured) out.colours.push_back(c);
    }
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint16_t* t = mesh.indices.data() + i;
    if (!has_area(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]])) continue;
    for (int corner = 0; corner < 3; ++corner) out.indices.push_back(vertex(t[corner]));
  }
  return out;
}

FixedMesh ordered(const FixedMesh& mesh) {
  FixedMesh out = without_arrays(mesh);
  const std::size_t vertices = mesh.positions.size();
  const std::vector<unsigned> from = wide_indices(mesh);
  std::vector<unsigned> to(from.size());
  meshopt_optimizeVertexCache(to.data(), from.data(), from.size(), vertices);
  std::vector<unsigned> place(vertices);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(place.data(), to.data(), to.size(), vertices);
  out.positions.resize(used);
  out.normals.resize(used);
  if (!mesh.texture_points.empty()) out.texture_points.resize(used);
  if (!mesh.colours.empty()) out.colours.resize(used);
  for (std::size_t i = 0; i < vertices; ++i) {
    if (place[i] >= used) continue;  // nothing uses it
    out.positions[place[i]] = mesh.positions[i];
    out.normals[place[i]] = mesh.normals[i];
    if (!mesh.texture_points.empty()) out.texture_points[place[i]] = mesh.texture_points[i];
    if (!mesh.colours.empty()) out.colours[place[i]] = mesh.colours[i];
  }
  for (const unsigned index : to) out.indices.push_back(static_cast<std::uint16_t>(place[index]));
  return out;
}

double cache_misses_per_triangle(const FixedMesh& mesh) {
  constexpr unsigned kCacheSize = 16;
  if (mesh.indices.empty()) return 0;
  const std::vector<unsigned> indices = wide_indices(mesh);
  const meshopt_VertexCacheStatistics found =
      meshopt_analyzeVertexCache(indices.data(), indices.size(), mesh.positions.size(), kCacheSize, 0, 0);
  return static_cast<double>(found.acmr);
}

}  // namespace arcspan::tools
