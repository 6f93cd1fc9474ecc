// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_neighbours.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace arcspan::test {

/// The neighbours of a mesh, found by comparing all edges with all. `creases`: all edges between triangles
/// are creases. Short distances of every second triangle are marked.
[[nodiscard]] inline std::vector<std::uint8_t> neighbours_of(const MeshView& mesh, bool creases = false) {
  constexpr std::size_t kNone = ~std::size_t{0};
  const std::size_t corners = 3 * mesh.triangle_count();
  std::vector<std::size_t> other(corners, kNone);
  const auto edge = [&](std::size_t corner) {
    return detail::edge_of(mesh.triangle(corner / 3), static_cast<unsigned>(corner % 3));
  };
  for (std::size_t i = 0; i < corners; ++i) {
    for (std::size_t j = 3 * (i / 3 + 1); j < corners && other[i] == kNone; ++j) {
      if (other[j] != kNone || !(mesh.position(edge(i).a) == mesh.position(edge(j).b)) ||
          !(mesh.position(edge(i).b) == mesh.position(edge(j).a)))
        continue;
      other[i] = j;
      other[j] = i;
    }
  }
  std::vector<std::uint8_t> bytes;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::size_t first = bytes.size();
    bytes.push_back(0);
    for (unsigned i = 0; i < 3; ++i) {
      const std::size_t beyond = other[3 * t + i];
      if (beyond == kNone) continue;
      const bool later = beyond / 3 > t;
      const unsigned kind = later ? (creases ? 3u : 2u) : 1u;
      bytes[first] = static_cast<std::uint8_t>(bytes[first] | (kind << (2 * i)));
      std::size_t number = beyond / 3 - t - 1;
      for (; later && number >= 128; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 128));
      if (later) bytes.push_back(static_cast<std::uint8_t>(number));
    }
    const std::size_t numbers = bytes.size() - first - 1;
    const bool are_short = std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(first) + 1, bytes.end(),
                                       [](std::uint8_t byte) { return byte < 128; });
    if (t % 2 == 0 && are_short && detail::has_ordinary_edges(bytes[first]))
      bytes[first] = static_cast<std::uint8_t>(bytes[first] | (numbers << 6));
  }
  return bytes;
}

/// A mesh's neighbours with their memory.
struct TestNeighbours {
  explicit TestNeighbours(const MeshView& mesh, bool creases = false) : bytes(neighbours_of(mesh, creases)) {
    if (!ok(MeshNeighbours::make(mesh, bytes, view))) std::abort();
  }
  std::vector<std::uint8_t> bytes;
  MeshNeighbours view;
};

}  // namespace arcspan::test
