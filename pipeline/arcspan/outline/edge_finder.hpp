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
#include <utility>

namespace arcspan::detail {

[[nodiscard]] constexpr bool is_seen(TriangleSide side) {
  return side == TriangleSide::kFront || side == TriangleSide::kBack;
}

/// The outline at the edge between triangle a, which stores the distance, and triangle b.
struct EdgeSides {
  /// kHidden: none. kFront: it leads along the edge in a's order of vertices; kBack: in the opposite one.
  TriangleSide side;
  bool is_silhouette;  ///< one shows its front, the other is hidden: the surface turns away here
};
/// By 4 * (side of a) + (side of b). Other pairs, such as those with kCut, are no outline.
inline constexpr std::array<EdgeSides, 16> kEdgeSides = [] {
  using enum TriangleSide;
  std::array<EdgeSides, 16> all{};
  const auto set = [&](TriangleSide a, TriangleSide b, TriangleSide side, bool is_silhouette) {
    all[4 * static_cast<std::size_t>(a) + static_cast<std::size_t>(b)] = {side, is_silhouette};
  };
  set(kFront, kHidden, kFront, true);
  set(kFront, kBack, kFront, false);
  set(kFront, kFront, kFront, false);  // a crease
  set(kHidden, kFront, kBack, true);
  set(kHidden, kBack, kFront, false);
  set(kBack, kFront, kBack, false);
  set(kBack, kHidden, kBack, false);
  set(kBack, kBack, kBack, false);  // a crease
  return all;
}();

/// Finds the outlines of one object, and calls edges.put(from, to, is_silhouette) for each: vertices in the
/// order of OutlineEdge. A crease has surface on both sides, so it is put twice, the second time with its
/// ends exchanged.
template <class Edges>
class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, std::span<const TriangleSide> sides, Edges& edges)
      : mesh_(mesh), sides_(sides.data()), edges_(edges) {}

  /// `at` is MeshNeighbours::bytes(). Most triangles have no outline: their later neighbours, one or two,
  /// show the same side.
  void find(const std::uint8_t* at) {
    const TriangleSide* next_side = sides_;
    for (const TriangleSide* const end = sides_ + mesh_.triangle_count(); next_side != end;) {
      const TriangleSide own = *next_side++;
      const unsigned distances = short_distances(*at);
      if (distances == 1) {
        if (next_side[at[1]] == own) {
          at += 2;
          continue;
        }
      } else if (distances == 2) {
        if (next_side[at[1]] == own && next_side[at[2]] == own) {
          at += 3;
          continue;
        }
      } else if (has_none(next_side, at)) {
        continue;
      }
      at = put_differing(next_side, at);
    }
  }

 private:
  /// For any triangle: true if it certainly has no outline, because its later neighbours show the same side,
  /// and it has no border or crease that is seen. Then `at` goes to the next triangle.
  ARCSPAN_INLINE static bool has_none(const TriangleSide* next_side, const std::uint8_t*& at) {
    const TriangleSide own = next_side[-1];
    const unsigned kinds = *at;
    if (is_seen(own) && !has_ordinary_edges(kinds)) return false;
    const std::uint8_t* next = at + 1;
    for (unsigned later = kinds & 0b101010u; later != 0; later &= later - 1)
      if (next_side[read_distance(next) - 1] != own) return false;
    at = next;
    return true;
  }

  /// Puts the outlines among the edges of a triangle. Returns the bytes of the next one.
  ARCSPAN_OUTLINE const std::uint8_t* put_differing(const TriangleSide* next_side, const std::uint8_t* at) {
    const TriangleSide* const side = next_side - 1;
    const TriangleSide own = *side;
    TriangleIndices t = mesh_.triangle(static_cast<std::size_t>(side - sides_));
    unsigned kinds = *at++;
    for (unsigned edge = 0; edge < 3; ++edge, kinds >>= 2, t = {t.b, t.c, t.a}) {
      const EdgeKind kind = edge_kind(kinds, 0);
      if (kind == EdgeKind::kEarlier) continue;
      const bool is_border = kind == EdgeKind::kBorder;
      const TriangleSide beyond = is_border ? TriangleSide::kHidden : side[read_distance(at)];
      if (own == beyond && kind != EdgeKind::kCrease) continue;
      const EdgeSides& sides =
          kEdgeSides[4 * static_cast<std::size_t>(own) + static_cast<std::size_t>(beyond)];
      if (sides.side == TriangleSide::kHidden) continue;
      std::size_t from = t.a;
      std::size_t to = t.b;
      if (sides.side == TriangleSide::kBack) std::swap(from, to);
      edges_.put(from, to, sides.is_silhouette && !is_border);
      if (own == beyond) edges_.put(to, from, false);
    }
    return at;
  }

  const MeshView& mesh_;
  const TriangleSide* sides_;
  Edges& edges_;
};

}  // namespace arcspan::detail
