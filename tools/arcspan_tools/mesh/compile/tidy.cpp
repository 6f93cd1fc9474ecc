// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/compile/tidy.hpp>
#include <meshoptimizer.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

/// Position, normal, texture point, colour, and what moves it.
using StoredVertex = std::pair<std::array<std::int16_t, 10>, std::uint32_t>;

bool has_area(const ObjectPosition& a, const ObjectPosition& b, const ObjectPosition& c) {
  const std::int64_t ux = b.x - a.x;
  const std::int64_t uy = b.y - a.y;
  const std::int64_t uz = b.z - a.z;
  const std::int64_t vx = c.x - a.x;
  const std::int64_t vy = c.y - a.y;
  const std::int64_t vz = c.z - a.z;
  return uy * vz != uz * vy || uz * vx != ux * vz || ux * vy != uy * vx;
}

/// Whether a pose of the mesh's rig can give an area to a triangle that has none.
bool has_area_in_a_pose(const FixedMesh& mesh, const std::uint16_t* t, const Rig* rig) {
  if (rig == nullptr || mesh.sources.empty()) return false;
  std::array<std::uint32_t, 3> sources{};
  std::array<bool, 3> joined{};
  for (std::size_t i = 0; i < 3; ++i) {
    sources[i] = mesh.sources[t[i]];
    if (sources[i] == kNoSource) return false;
    joined[i] = mesh.positions[t[i]] == mesh.positions[t[(i + 1) % 3]];
  }
  return can_open(*rig, sources, joined);
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

FixedMesh compacted(const FixedMesh& mesh, const Rig* rig) {
  FixedMesh out = without_arrays(mesh);
  std::map<StoredVertex, std::uint16_t> known;
  const auto vertex = [&](std::size_t i) {
    const ObjectPosition& p = mesh.positions[i];
    const PackedNormal& n = mesh.normals[i];
    const bool textured = !mesh.texture_points.empty();
    const TexturePoint t = textured ? mesh.texture_points[i] : TexturePoint{};
    const auto next = static_cast<std::uint16_t>(out.positions.size());
    const bool coloured = !mesh.colours.empty();
    const Rgb8 c = coloured ? mesh.colours[i] : Rgb8{};
    const std::uint32_t source = mesh.sources.empty() ? kNoSource : mesh.sources[i];
    const auto [at, is_new] =
        known.try_emplace(StoredVertex{{p.x, p.y, p.z, n.u, n.v, t.u, t.v, c.r, c.g, c.b}, source}, next);
    if (is_new) {
      out.positions.push_back(p);
      out.normals.push_back(n);
      if (textured) out.texture_points.push_back(t);
      if (coloured) out.colours.push_back(c);
      if (!mesh.sources.empty()) out.sources.push_back(source);
    }
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint16_t* t = mesh.indices.data() + i;
    if (!has_area(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]) &&
        !has_area_in_a_pose(mesh, t, rig))
      continue;
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
  if (!mesh.sources.empty()) out.sources.resize(used);
  for (std::size_t i = 0; i < vertices; ++i) {
    if (place[i] >= used) continue;  // nothing uses it
    out.positions[place[i]] = mesh.positions[i];
    out.normals[place[i]] = mesh.normals[i];
    if (!mesh.texture_points.empty()) out.texture_points[place[i]] = mesh.texture_points[i];
    if (!mesh.colours.empty()) out.colours[place[i]] = mesh.colours[i];
    if (!mesh.sources.empty()) out.sources[place[i]] = mesh.sources[i];
  }
  for (const unsigned index : to) out.indices.push_back(static_cast<std::uint16_t>(place[index]));
  return out;
}

FixedMesh with_separate_slots(const FixedMesh& mesh) {
  FixedMesh out = without_arrays(mesh);
  constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);  // the newest of each vertex
  const auto copy = [&](std::uint16_t i) {
    number[i] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(mesh.positions[i]);
    out.normals.push_back(mesh.normals[i]);
    if (!mesh.texture_points.empty()) out.texture_points.push_back(mesh.texture_points[i]);
    if (!mesh.colours.empty()) out.colours.push_back(mesh.colours[i]);
    if (!mesh.sources.empty()) out.sources.push_back(mesh.sources[i]);
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint16_t* t = mesh.indices.data() + i;
    auto next = static_cast<std::uint32_t>(out.positions.size());
    std::array<std::uint32_t, 3> slots{};
    for (std::size_t k = 0; k < 3; ++k)
      slots[k] = (number[t[k]] == kUnused ? next++ : number[t[k]]) % kVertexSlots;
    const bool collide = slots[0] == slots[1] || slots[1] == slots[2] || slots[2] == slots[0];
    if (collide && out.positions.size() + 3 > kMaxVertices) return mesh;
    for (std::size_t k = 0; k < 3; ++k) {
      if (collide || number[t[k]] == kUnused) copy(t[k]);
      out.indices.push_back(static_cast<std::uint16_t>(number[t[k]]));
    }
  }
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
