// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::detail {

[[nodiscard]] constexpr bool is_seen(TriangleSide side) {
  return side == TriangleSide::kFront || side == TriangleSide::kBack;
}

/// For the first byte of a triangle: how many numbers of neighbours follow, and kMarked if there is a border
/// or a crease.
inline constexpr std::uint8_t kMarked = 4;
inline constexpr std::array<std::uint8_t, 64> kNumbersAfter = [] {
  std::array<std::uint8_t, 64> numbers{};
  for (unsigned kinds = 0; kinds < 64; ++kinds) {
    for (unsigned edge = 0; edge < 3; ++edge) {
      const EdgeKind kind = edge_kind(kinds, edge);
      if (has_distance(kind)) ++numbers[kinds];
      if (kind == EdgeKind::kBorder || kind == EdgeKind::kCrease) numbers[kinds] |= kMarked;
    }
  }
  return numbers;
}();

/// Finds the outlines of one object, and calls edges.put(ends, side, is_silhouette) for each: `ends` from a
/// to b in the order of OutlineEdge if `side` is kFront, otherwise from b to a. At a silhouette the surface
/// turns away: a front is seen, and the triangle beyond is hidden.
template <class Edges>
class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, std::span<const TriangleSide> sides, Edges& edges)
      : mesh_(mesh), sides_(sides.data()), edges_(edges) {}

  void find(const std::uint8_t* at) {
    const TriangleSide* const end = sides_ + mesh_.triangle_count();
    for (const TriangleSide* side = sides_; side != end; ++side) at = find_of_triangle(side, at);
  }

 private:
  /// Returns the bytes of the next triangle. Most triangles have no outline: their neighbours show the same
  /// side, and they are not marked, or not seen.
  ARCSPAN_INLINE const std::uint8_t* find_of_triangle(const TriangleSide* side, const std::uint8_t* at) {
    const TriangleSide own = *side;
    const std::uint8_t* next = at + 1;
    unsigned numbers = kNumbersAfter[*at];
    if (numbers >= kMarked) {
      if (is_seen(own)) return put_differing(side, at);
      numbers -= kMarked;
    }
    for (; numbers != 0; --numbers)
      if (side[read_distance(next)] != own) return put_differing(side, at);
    return next;
  }

  /// Puts the outlines among the edges of a triangle. Returns the bytes of the next one.
  ARCSPAN_OUTLINE const std::uint8_t* put_differing(const TriangleSide* at_side, const std::uint8_t* at) {
    const auto i = static_cast<std::size_t>(at_side - sides_);
    unsigned kinds = *at++;
    const TriangleSide side = sides_[i];
    for (unsigned edge = 0; edge < 3; ++edge, kinds >>= 2) {
      const EdgeKind kind = edge_kind(kinds, 0);
      if (kind == EdgeKind::kBorder && is_seen(side)) put(i, edge, side);
      if (!has_distance(kind)) continue;
      const TriangleSide beyond = sides_[i + read_distance(at)];
      if (side != beyond || kind == EdgeKind::kCrease) put_between(i, edge, side, beyond, kind);
    }
    return at;
  }

  /// Puts an edge between two triangles.
  void put_between(std::size_t i, unsigned edge, TriangleSide side, TriangleSide beyond, EdgeKind kind) {
    if (side == TriangleSide::kCut || beyond == TriangleSide::kCut) return;
    if (side == beyond) {
      if (kind != EdgeKind::kCrease || !is_seen(side)) return;
      put(i, edge, side);
      put(i, edge, other_way(beyond));
    } else if (side == TriangleSide::kFront || beyond == TriangleSide::kHidden) {
      put(i, edge, side, side == TriangleSide::kFront && beyond == TriangleSide::kHidden);
    } else {
      put(i, edge, other_way(beyond), beyond == TriangleSide::kFront && side == TriangleSide::kHidden);
    }
  }

  /// The edge of the triangle beyond runs in the opposite direction.
  [[nodiscard]] static TriangleSide other_way(TriangleSide side) {
    return side == TriangleSide::kFront ? TriangleSide::kBack : TriangleSide::kFront;
  }

  /// Puts an edge of triangle i, which shows `side`.
  void put(std::size_t i, unsigned edge, TriangleSide side, bool is_silhouette = false) {
    edges_.put(edge_of(mesh_.triangle(i), edge), side, is_silhouette);
  }

  const MeshView& mesh_;
  const TriangleSide* sides_;
  Edges& edges_;
};

}  // namespace arcspan::detail
