// SPDX-License-Identifier: MIT
#include <arcspan/outline/outline_edges.hpp>

namespace arcspan {

namespace {

[[nodiscard]] bool is_seen(TriangleSide side) {
  return side == TriangleSide::kFront || side == TriangleSide::kBack;
}

/// Finds the outlines of one object.
class EdgeFinder {
 public:
  EdgeFinder(const MeshView& mesh, const ClipTransform& transform, std::span<const TriangleSide> sides,
             std::span<OutlineEdge> memory)
      : mesh_(mesh), transform_(transform), sides_(sides), memory_(memory) {}

  void find(const std::uint8_t* at) {
    for (std::size_t i = 0; i < mesh_.triangle_count(); ++i) {
      unsigned kinds = *at++;
      const TriangleSide side = sides_[i];
      for (unsigned edge = 0; edge < 3; ++edge, kinds >>= 2) {
        const EdgeKind kind = detail::edge_kind(kinds, 0);
        if (kind == EdgeKind::kEarlier) continue;
        if (kind == EdgeKind::kBorder) {
          if (is_seen(side)) put(i, edge, side);
          continue;
        }
        const TriangleSide beyond = sides_[i + detail::read_distance(at)];
        if (side != beyond || kind == EdgeKind::kCrease) put_between(i, edge, side, beyond, kind);
      }
    }
  }

  /// Edges found, also those for which there was no memory.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
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
      const RasterPosition a = project(transform_(mesh_.position(ends.a)), transform_);
      const RasterPosition b = project(transform_(mesh_.position(ends.b)), transform_);
      memory_[count_] = side == TriangleSide::kFront ? OutlineEdge{a, b} : OutlineEdge{b, a};
    }
    ++count_;
  }

  const MeshView& mesh_;
  const ClipTransform& transform_;
  std::span<const TriangleSide> sides_;
  std::span<OutlineEdge> memory_;
  std::size_t count_ = 0;
};

}  // namespace

Status OutlineEdges::add(const MeshView& mesh, const MeshNeighbours& neighbours,
                         const ClipTransform& transform, std::span<const TriangleSide> sides) {
  if (neighbours.triangle_count() == 0 && mesh.triangle_count() != 0) return Status::kUnsupported;
  const Viewport& viewport = transform.viewport();
  if (neighbours.triangle_count() != mesh.triangle_count() || sides.size() < mesh.triangle_count() ||
      (count_ != 0 && !(viewport == viewport_)))
    return Status::kInvalidArgument;
  EdgeFinder finder(mesh, transform, sides, memory_.subspan(count_));
  finder.find(neighbours.bytes());
  if (finder.count() > memory_.size() - count_) return Status::kBufferTooSmall;
  viewport_ = viewport;
  count_ += finder.count();
  return Status::kOk;
}

}  // namespace arcspan
