// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/plain/subset.hpp>

#include <cstddef>

namespace arcspan::tools {

MeshData subset(const MeshData& mesh, std::span<const std::array<std::uint32_t, 3>> triangles) {
  constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  std::vector<std::uint32_t> now(mesh.positions.size(), kUnused);
  for (const auto& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) now[vertex] = 0;
  }
  MeshData out;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == kUnused) continue;
    now[i] = static_cast<std::uint32_t>(out.positions.size());
    out.positions.push_back(mesh.positions[i]);
    out.normals.push_back(mesh.normals[i]);
    if (!mesh.texture_points.empty()) out.texture_points.push_back(mesh.texture_points[i]);
    if (!mesh.colours.empty()) out.colours.push_back(mesh.colours[i]);
    if (!mesh.sources.empty()) out.sources.push_back(mesh.sources[i]);
  }
  for (const auto& t : triangles) out.triangles.push_back({now[t[0]], now[t[1]], now[t[2]]});
  return out;
}

std::vector<MeshData> in_pieces(const MeshData& mesh, std::size_t most_vertices) {
  if (mesh.positions.size() <= most_vertices) return {mesh};
  std::vector<std::size_t> piece_of(mesh.positions.size());  // the last that uses a vertex, from 1
  std::vector<MeshData> pieces;
  const std::span triangles(mesh.triangles);
  std::size_t begin = 0;
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto use = [&] {
      std::size_t more = 0;
      for (const std::uint32_t vertex : triangles[i]) {
        if (piece_of[vertex] == pieces.size() + 1) continue;
        piece_of[vertex] = pieces.size() + 1;
        ++more;
      }
      return more;
    };
    vertices += use();
    if (vertices <= most_vertices) continue;
    pieces.push_back(subset(mesh, triangles.subspan(begin, i - begin)));
    begin = i;
    vertices = use();
  }
  pieces.push_back(subset(mesh, triangles.subspan(begin)));
  return pieces;
}

}  // namespace arcspan::tools
