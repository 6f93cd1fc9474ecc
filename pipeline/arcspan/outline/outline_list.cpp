// SPDX-License-Identifier: MIT
#include <arcspan/outline/edge_finder.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

namespace {

/// Writes edges into the memory of a list.
class ListedEdges {
 public:
  ListedEdges(const MeshView& mesh, const VertexPositions& positions, std::span<OutlineEdge> memory)
      : mesh_(mesh), positions_(positions), memory_(memory) {}

  ARCSPAN_OUTLINE void put(std::size_t from, std::size_t to, bool) {
    if (count_ < memory_.size()) {
      OutlineEdge& edge = memory_[count_];
      positions_.take(mesh_, from, edge.from);
      positions_.take(mesh_, to, edge.to);
    }
    ++count_;
  }
  /// Edges put, also those for which there was no memory.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  const MeshView& mesh_;
  const VertexPositions& positions_;
  std::span<OutlineEdge> memory_;
  std::size_t count_ = 0;
};

/// The pixels that smoothing changes at an edge, and `more` on all sides, from the raster's origin. A
/// pixel whose centre is on a top or left edge is inside (top-left rule), so that the pixel before it is
/// changed, too.
[[nodiscard]] Rect pixels_at(const OutlineEdge& edge, std::int32_t more) {
  const auto first = [=](std::int32_t a, std::int32_t b) { return (((a < b ? a : b) - 9) >> 4) - more; };
  const auto end = [=](std::int32_t a, std::int32_t b) { return (((a < b ? b : a) + 24) >> 4) + more; };
  const RasterPosition& a = edge.from;
  const RasterPosition& b = edge.to;
  return {first(a.x, b.x), first(a.y, b.y), end(a.x, b.x), end(a.y, b.y)};
}

}  // namespace

ARCSPAN_OUTLINE void VertexPositions::transform(const MeshView& mesh, std::size_t i,
                                                RasterPosition& position) const {
  position = project((*transform_)(mesh.position(i)), *transform_);
}

Status OutlineList::check(const MeshView& mesh, const MeshNeighbours& neighbours,
                          const VertexPositions& positions, std::span<const TriangleSide> sides) const {
  if (neighbours.triangle_count() == 0 && mesh.triangle_count() != 0) return Status::kUnsupported;
  if (neighbours.triangle_count() != mesh.triangle_count() || sides.size() < mesh.triangle_count() ||
      positions.count() < mesh.vertex_count() || (count_ != 0 && !(positions.viewport() == viewport_)))
    return Status::kInvalidArgument;
  return Status::kOk;
}

Status OutlineList::add(const MeshView& mesh, const MeshNeighbours& neighbours,
                        const VertexPositions& positions, std::span<const TriangleSide> sides) {
  const Status status = check(mesh, neighbours, positions, sides);
  if (!ok(status)) return status;
  ListedEdges edges(mesh, positions, free_memory());
  detail::EdgeFinder<ListedEdges>(mesh, sides, edges).find(neighbours.bytes());
  return take(edges.count(), positions.viewport()) ? Status::kOk : Status::kBufferTooSmall;
}

Rect OutlineList::changed_rect(std::uint8_t ink_width) const {
  const std::int32_t more = (3 * ink_width + 1) / 2;  // ink lies at an angle
  const std::int32_t x = viewport_.width >> 1;
  const std::int32_t y = viewport_.height >> 1;
  Rect all{};
  for (const OutlineEdge& edge : edges()) {
    const Rect at = pixels_at(edge, more);
    const Rect in_picture{at.left + x, at.top + y, at.right + x, at.bottom + y};
    all = bounding_rect(all, detail::intersection({0, 0, viewport_.width, viewport_.height}, in_picture));
  }
  return all;
}

}  // namespace arcspan
