// SPDX-License-Identifier: MIT
#include <arcspan/outline/edge_finder.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <span>

namespace arcspan {

namespace {

/// Writes edges into the memory of a list.
class ListedEdges {
 public:
  ListedEdges(const MeshView& mesh, const VertexPositions& positions, std::span<OutlineEdge> memory)
      : mesh_(mesh), positions_(positions), memory_(memory) {}

  ARCSPAN_INLINE void put(const TriangleIndices& ends, TriangleSide side, bool) {
    if (count_ < memory_.size()) {
      const RasterPosition a = positions_(mesh_, ends.a);
      const RasterPosition b = positions_(mesh_, ends.b);
      memory_[count_] = side == TriangleSide::kFront ? OutlineEdge{a, b} : OutlineEdge{b, a};
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

}  // namespace

RasterPosition VertexPositions::operator()(const MeshView& mesh, std::size_t i) const {
  if (cached_ == nullptr || outcodes_[i * stride_] == kNotTransformed)
    return project((*transform_)(mesh.position(i)), *transform_);
  return *static_cast<const RasterPosition*>(static_cast<const void*>(cached_ + i * stride_));
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

}  // namespace arcspan
