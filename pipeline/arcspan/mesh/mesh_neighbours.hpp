// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// What is beyond an edge of a triangle: 2 bits of the byte that a triangle begins with (MeshNeighbours).
enum class EdgeKind : std::uint8_t {
  kBorder = 0,   ///< nothing
  kEarlier = 1,  ///< a triangle with a smaller number, which has the edge's kind and distance
  kLater = 2,    ///< a triangle with a greater number; the distance to it follows
  kCrease = 3,   ///< as kLater, where normals or colours differ: an outline even if both sides are seen
};

namespace detail {

// The reasons of MeshNeighbours::of().
namespace refused {
void neighbours_not_of_as_many_triangles();
void neighbours_of_another_mesh();
}  // namespace refused

/// The edge of triangle `t` from its corner 0, 1 or 2 to the next one; `c` is unused.
[[nodiscard]] constexpr TriangleIndices edge_of(const TriangleIndices& t, unsigned edge) {
  if (edge == 0) return {t.a, t.b, 0};
  return edge == 1 ? TriangleIndices{t.b, t.c, 0} : TriangleIndices{t.c, t.a, 0};
}

/// The kind of edge 0, 1 or 2 in the byte of a triangle.
[[nodiscard]] ARCSPAN_INLINE constexpr EdgeKind edge_kind(unsigned kinds, unsigned edge) {
  return static_cast<EdgeKind>((kinds >> (2 * edge)) & 3u);
}

/// True if a distance follows for an edge of this kind.
[[nodiscard]] ARCSPAN_INLINE constexpr bool has_distance(EdgeKind kind) { return kind >= EdgeKind::kLater; }

/// True if all edges are kEarlier or kLater.
[[nodiscard]] ARCSPAN_INLINE constexpr bool has_ordinary_edges(unsigned kinds) {
  return ((kinds ^ (kinds >> 1)) & 0b010101u) == 0b010101u;
}

/// How many distances follow the byte of a triangle, if they all have one byte and the triangle has neither
/// border nor crease; otherwise 0, or by choice of the writer.
[[nodiscard]] ARCSPAN_INLINE constexpr unsigned short_distances(unsigned kinds) { return kinds >> 6; }

/// Reads a distance of at least 1 that MeshNeighbours::make() has accepted: 7 bits per byte, the lower ones
/// first; the upper bit is set if a byte follows.
[[nodiscard]] ARCSPAN_INLINE constexpr std::size_t read_distance(const std::uint8_t*& at) {
  std::uint32_t distance = *at++;
  std::uint32_t byte = distance;
  for (int shift = 7; byte >= 128; shift += 7) {
    byte = *at++;
    distance += (byte - 1) << shift;  // 1 is the upper bit of the byte before
  }
  return static_cast<std::size_t>(distance) + 1;
}

/// Checks the bytes of neighbours one after another.
class NeighbourCheck {
 public:
  constexpr NeighbourCheck(const MeshView& mesh, std::span<const std::uint8_t> bytes)
      : mesh_(mesh), bytes_(bytes) {}

  [[nodiscard]] constexpr Status run() {
    const std::size_t count = mesh_.triangle_count();
    Status status = Status::kOk;
    for (std::size_t i = 0; i < count && ok(status); ++i) status = check_triangle(i);
    if (!ok(status)) return status;
    return at_ == bytes_.size() && named_ == 0 ? Status::kOk : Status::kCorrupted;
  }

 private:
  constexpr Status check_triangle(std::size_t i) {
    if (at_ == bytes_.size()) return Status::kCorrupted;
    const std::size_t first = at_;
    const unsigned kinds = bytes_[at_++];
    Status status = Status::kOk;
    unsigned distances = 0;
    for (unsigned edge = 0; edge < 3 && ok(status); ++edge) {
      const EdgeKind kind = edge_kind(kinds, edge);
      if (kind == EdgeKind::kEarlier) {
        if (named_-- == 0) return Status::kCorrupted;
      } else if (has_distance(kind)) {
        ++named_;
        ++distances;
        status = check_distance(i, edge);
      }
    }
    if (!ok(status) || short_distances(kinds) == 0) return status;
    const bool are_short = at_ - first == distances + 1;
    return short_distances(kinds) == distances && are_short && has_ordinary_edges(kinds) ? Status::kOk
                                                                                         : Status::kCorrupted;
  }

  /// Of at most 5 bytes; numbers have fewer than 32 bits.
  constexpr Status check_distance(std::size_t i, unsigned edge) {
    std::uint64_t distance = 1;
    for (int shift = 0; shift < 35; shift += 7) {
      if (at_ == bytes_.size()) return Status::kCorrupted;
      const std::uint8_t byte = bytes_[at_++];
      distance += std::uint64_t{byte & 127u} << shift;
      if (byte >= 128) continue;
      if (distance >= mesh_.triangle_count() - i) return Status::kIndexOutOfRange;
      return is_reversed_in(edge_of(mesh_.triangle(i), edge),
                            mesh_.triangle(i + static_cast<std::size_t>(distance)))
                 ? Status::kOk
                 : Status::kInvalidArgument;
    }
    return Status::kCorrupted;
  }

  /// True if the triangle has an edge from the end of `edge` to its beginning.
  [[nodiscard]] constexpr bool is_reversed_in(const TriangleIndices& edge, const TriangleIndices& t) const {
    for (unsigned other = 0; other < 3; ++other) {
      const TriangleIndices candidate = edge_of(t, other);
      if (mesh_.position(edge.a) == mesh_.position(candidate.b) &&
          mesh_.position(edge.b) == mesh_.position(candidate.a))
        return true;
    }
    return false;
  }

  const MeshView& mesh_;
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::uint32_t named_ = 0;  ///< edges named by earlier triangles and not met yet
};

}  // namespace detail

/// A view of the neighbours of a mesh's triangles in memory of the caller, usually flash, which must outlive
/// it: 2.5 to 2.7 bytes per triangle, written by `arcspan mesh --outlines`. OutlineList needs it.
///
/// For each triangle in the order of the mesh there is a byte with the EdgeKind of its edges ab (bits 0, 1),
/// bc (2, 3) and ca (4, 5), then for each edge of them that is kLater or kCrease the number of the triangle
/// beyond it: how much greater it is than that of this one, minus 1, 7 bits per byte, the lower ones first,
/// with the upper bit set in all bytes but the last. If the edges are kEarlier or kLater, and each distance
/// has one byte, bits 6 and 7 are how many there are, so that reading most triangles is fast; they may be 0.
/// Edges are the same if their ends are at the same positions, in the opposite order, whatever normals and
/// texture points they have.
class MeshNeighbours {
 public:
  constexpr MeshNeighbours() = default;

  /// Makes a view of neighbours, which are checked here once, so that reading them need not. Returns:
  ///
  ///   kOk                `neighbours` is set; otherwise it is not changed
  ///   kCorrupted         `bytes` end too early or too late for mesh.triangle_count() triangles, bits 6 and
  ///                      7 are wrong, a distance has more than 5 bytes, or there are not as many edges that
  ///                      are kEarlier as kLater and kCrease
  ///   kIndexOutOfRange   a number names no triangle
  ///   kInvalidArgument   a triangle beyond an edge has no edge with these ends: those of another mesh
  static constexpr Status make(const MeshView& mesh, std::span<const std::uint8_t> bytes,
                               MeshNeighbours& neighbours) {
    const Status status = detail::NeighbourCheck(mesh, bytes).run();
    if (!ok(status)) return status;
    neighbours.bytes_ = bytes.data();
    neighbours.triangle_count_ = mesh.triangle_count();
    return Status::kOk;
  }

  /// make() as a constant. Neighbours that make() rejects do not compile.
  [[nodiscard]] static consteval MeshNeighbours of(const MeshView& mesh,
                                                   std::span<const std::uint8_t> bytes) {
    MeshNeighbours neighbours;
    const Status status = make(mesh, bytes, neighbours);
    if (status == Status::kInvalidArgument) detail::refused::neighbours_of_another_mesh();
    if (status == Status::kIndexOutOfRange) detail::refused::index_out_of_range();
    if (status == Status::kCorrupted) detail::refused::neighbours_not_of_as_many_triangles();
    return neighbours;
  }

  /// 0 if the view was never made.
  [[nodiscard]] constexpr std::size_t triangle_count() const { return triangle_count_; }
  /// The bytes of the first triangle, or null.
  [[nodiscard]] constexpr const std::uint8_t* bytes() const { return bytes_; }

 private:
  const std::uint8_t* bytes_ = nullptr;
  std::size_t triangle_count_ = 0;
};

}  // namespace arcspan
