// SPDX-License-Identifier: MIT
#include <arcspan/outline/outline_list.hpp>

#include <array>

namespace arcspan {

namespace {

[[nodiscard]] bool is_seen(TriangleSide side) {
  return side == TriangleSide::kFront || side == TriangleSide::kBack;
}

constexpr std::uint8_t kNotPlain = 4;

/// For the first byte of a triangle: how many numbers of neighbours follow if it has neither borders nor
/// creases, else kNotPlain.
constexpr std::array<std::uint8_t, 64> kNumbersOfPlain = [] {
  std::array<std::uint8_t, 64> numbers{};
  for (unsigned kinds = 0; kinds < 64; ++kinds) {
    bool plain = true;
    for (unsigned edge = 0; edge < 3; ++edge) {
      const EdgeKind kind = detail::edge_kind(kinds, edge);
      if (kind == EdgeKind::kLater) ++numbers[kinds];
      if (kind == EdgeKind::kBorder || kind == EdgeKind::kCrease) plain = false;
    }
    if (!plain) numbers[kinds] = kNotPlain;
  }
  return numbers;
}();

/// Finds the outlines of one object.
class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, const VertexPositions& positions, std::span<const TriangleSide> sides,
             std::span<OutlineEdge> memory)
      : mesh_(mesh), positions_(positions), sides_(sides.data()), memory_(memory) {}

  void find(const std::uint8_t* at) {
    const TriangleSide* const end = sides_ + mesh_.triangle_count();
    for (const TriangleSide* side = sides_; side != end; ++side) at = find_of_triangle(side, at);
  }

  /// Edges found, also those for which there was no memory.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  /// Returns the bytes of the next triangle. Most triangles are plain, and most of their neighbours have the
  /// same side and a number of one byte. Which edge it is does not matter then.
  ARCSPAN_INLINE const std::uint8_t* find_of_triangle(const TriangleSide* side, const std::uint8_t* at) {
    const unsigned numbers = kNumbersOfPlain[*at];
    if (numbers == 2) {
      const unsigned one = at[1];
      const unsigned other = at[2];
      if ((one | other) < 128 && side[one + 1] == *side && side[other + 1] == *side) return at + 3;
    } else if (numbers == 1) {
      const unsigned one = at[1];
      if (one < 128 && side[one + 1] == *side) return at + 2;
    } else if (numbers == 0) {
      return at + 1;
    }
    return put_differing(static_cast<std::size_t>(side - sides_), at);
  }

  /// Puts the outlines among the edges of a triangle. Returns the bytes of the next one.
  ARCSPAN_OUTLINE const std::uint8_t* put_differing(std::size_t i, const std::uint8_t* at) {
    unsigned kinds = *at++;
    const TriangleSide side = sides_[i];
    for (unsigned edge = 0; edge < 3; ++edge, kinds >>= 2) {
      const EdgeKind kind = detail::edge_kind(kinds, 0);
      if (kind == EdgeKind::kBorder && is_seen(side)) put(i, edge, side);
      if (!detail::has_distance(kind)) continue;
      const TriangleSide beyond = sides_[i + detail::read_distance(at)];
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
      put(i, edge, side);
    } else {
      put(i, edge, other_way(beyond));
    }
  }

  /// The edge of the triangle beyond runs in the opposite direction.
  [[nodiscard]] static TriangleSide other_way(TriangleSide side) {
    return side == TriangleSide::kFront ? TriangleSide::kBack : TriangleSide::kFront;
  }

  /// Puts an edge of triangle i, which shows `side`.
  void put(std::size_t i, unsigned edge, TriangleSide side) {
    if (count_ < memory_.size()) {
      const TriangleIndices ends = detail::edge_of(mesh_.triangle(i), edge);
      const RasterPosition a = positions_(mesh_, ends.a);
      const RasterPosition b = positions_(mesh_, ends.b);
      memory_[count_] = side == TriangleSide::kFront ? OutlineEdge{a, b} : OutlineEdge{b, a};
    }
    ++count_;
  }

  const MeshView& mesh_;
  const VertexPositions& positions_;
  const TriangleSide* sides_;
  std::span<OutlineEdge> memory_;
  std::size_t count_ = 0;
};

}  // namespace

RasterPosition VertexPositions::operator()(const MeshView& mesh, std::size_t i) const {
  if (cached_ == nullptr || outcodes_[i * stride_] == kNotTransformed)
    return project((*transform_)(mesh.position(i)), *transform_);
  return *static_cast<const RasterPosition*>(static_cast<const void*>(cached_ + i * stride_));
}

Status OutlineList::add(const MeshView& mesh, const MeshNeighbours& neighbours,
                        const VertexPositions& positions, std::span<const TriangleSide> sides) {
  if (neighbours.triangle_count() == 0 && mesh.triangle_count() != 0) return Status::kUnsupported;
  const Viewport& viewport = positions.viewport();
  if (neighbours.triangle_count() != mesh.triangle_count() || sides.size() < mesh.triangle_count() ||
      positions.count() < mesh.vertex_count() || (count_ != 0 && !(viewport == viewport_)))
    return Status::kInvalidArgument;
  EdgeFinder finder(mesh, positions, sides, memory_.subspan(count_));
  finder.find(neighbours.bytes());
  if (finder.count() > memory_.size() - count_) return Status::kBufferTooSmall;
  viewport_ = viewport;
  count_ += finder.count();
  return Status::kOk;
}

}  // namespace arcspan
