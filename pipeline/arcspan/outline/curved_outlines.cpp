// SPDX-License-Identifier: MIT
#include <arcspan/numbers/direction.hpp>
#include <arcspan/outline/curved_outlines.hpp>
#include <arcspan/outline/edge_finder.hpp>
#include <arcspan/prepare/triangle.hpp>

namespace arcspan {

namespace {

using detail::DrawnVertex;

/// The middle of a curve, which may not fit 16 bits:
/// (a + b) / 2 - (w_ab n_a + w_ba n_b) / 8 with w_ab = (b - a) . n_a and w_ba = (a - b) . n_b.
[[nodiscard]] ObjectPoint middle_of(const DrawnVertex& a, const DrawnVertex& b) {
  const auto along = [&](const Direction& n) {  // 15 fraction bits, at most 2^34
    return std::int64_t{b.position.x - a.position.x} * n.x.raw() +
           std::int64_t{b.position.y - a.position.y} * n.y.raw() +
           std::int64_t{b.position.z - a.position.z} * n.z.raw();
  };
  const std::int64_t w_ab = along(a.normal);
  const std::int64_t w_ba = -along(b.normal);
  constexpr int kDown = 2 * DirectionComponent::kFraction + 3;
  constexpr std::int64_t kHalf = std::int64_t{1} << (kDown - 1);
  const auto middle = [&](std::int32_t sum, DirectionComponent na, DirectionComponent nb) {
    const std::int64_t bulge = w_ab * na.raw() + w_ba * nb.raw();  // at most 2^50
    return static_cast<std::int32_t>((sum * kHalf - bulge + kHalf) >> kDown);
  };
  return {middle(a.position.x + b.position.x, a.normal.x, b.normal.x),
          middle(a.position.y + b.position.y, a.normal.y, b.normal.y),
          middle(a.position.z + b.position.z, a.normal.z, b.normal.z)};
}

/// Finds the curves and outlines of one object.
class CurveFinder {
 public:
  CurveFinder(const detail::DrawnVertices& vertices, const MeshView& mesh, const VertexPositions& positions,
              std::span<OutlineEdge> edges, std::span<ObjectPosition> curve_positions,
              std::span<PackedNormal> curve_normals)
      : vertices_(vertices),
        mesh_(mesh),
        positions_(positions),
        edges_(edges),
        curve_positions_(curve_positions),
        curve_normals_(curve_normals) {}

  void put(std::size_t from, std::size_t to, bool is_silhouette) {
    const OutlineEdge edge{positions_(mesh_, from), positions_(mesh_, to)};
    RasterPosition middle;
    if (is_silhouette && put_curve(from, to, edge, middle)) {
      put({edge.from, middle});
      put({middle, edge.to});
    } else {
      put(edge);
    }
  }

  [[nodiscard]] std::size_t edge_count() const { return edge_count_; }
  [[nodiscard]] std::size_t curve_count() const { return curve_count_; }
  [[nodiscard]] Status status() const { return status_; }

 private:
  void put(const OutlineEdge& edge) {
    if (edge_count_ < edges_.size()) edges_[edge_count_] = edge;
    ++edge_count_;
  }

  /// Puts the curve over an edge, if there is one, and sets `middle` to where it is seen.
  [[nodiscard]] bool put_curve(std::size_t from, std::size_t to, const OutlineEdge& edge,
                               RasterPosition& middle) {
    const DrawnVertex a = vertices_[from];
    const DrawnVertex b = vertices_[to];
    if (dot(a.normal, b.normal) < Cosine::of(0.3)) return false;
    const ObjectPoint m = middle_of(a, b);
    const auto narrow = [](std::int32_t v) { return static_cast<std::int16_t>(v); };
    const ObjectPosition position{narrow(m.x), narrow(m.y), narrow(m.z)};
    if (position.x != m.x || position.y != m.y || position.z != m.z) return refuse(Status::kScaleOutOfRange);
    const ClipTransform& transform = positions_.transform();
    const ClipPosition clip = transform(position);
    if (outcode(clip, transform.w_range()) != kInside) return false;
    middle = project(clip, transform);
    if (!is_outside(edge, middle)) return false;
    const std::size_t first = 3 * curve_count_;
    if (first + 3 > curve_positions_.size()) return refuse(Status::kBufferTooSmall);
    put_vertex(first, b.position, b.packed);
    put_vertex(first + 1, a.position, a.packed);
    put_vertex(first + 2, position,
               pack_normal(a.normal.x.raw() + b.normal.x.raw(), a.normal.y.raw() + b.normal.y.raw(),
                           a.normal.z.raw() + b.normal.z.raw()));
    ++curve_count_;
    return true;
  }

  void put_vertex(std::size_t i, const ObjectPosition& position, PackedNormal normal) {
    curve_positions_[i] = position;
    curve_normals_[i] = normal;
  }

  [[nodiscard]] bool refuse(Status status) {
    if (ok(status_)) status_ = status;
    return false;
  }

  /// True if a point is outside of the surface by at least an eighth of a pixel, and at most three
  /// eighths of the edge: over one that is seen nearly end-on a curve would be a spike.
  [[nodiscard]] static bool is_outside(const OutlineEdge& edge, const RasterPosition& point) {
    const auto magnitude = [](std::int32_t v) { return v < 0 ? -v : v; };
    const std::int32_t dx = magnitude(edge.to.x - edge.from.x);
    const std::int32_t dy = magnitude(edge.to.y - edge.from.y);
    const std::int32_t length = dx > dy ? dx + dy / 2 : dy + dx / 2;  // at most 12 % too long
    constexpr std::int32_t kLeast = 2;                                // sixteenths
    const std::int32_t area = -doubled_area(edge.to, edge.from, point);
    return area >= kLeast * length + 1 && area <= std::int64_t{length} * length * 3 / 8;
  }

  const detail::DrawnVertices& vertices_;
  const MeshView& mesh_;
  const VertexPositions& positions_;
  std::span<OutlineEdge> edges_;
  std::span<ObjectPosition> curve_positions_;
  std::span<PackedNormal> curve_normals_;
  std::size_t edge_count_ = 0;
  std::size_t curve_count_ = 0;
  Status status_ = Status::kOk;
};

}  // namespace

Status CurvedOutlines::add(const detail::DrawnVertices& vertices, const MeshView& triangles,
                           const MeshNeighbours& neighbours, const VertexPositions& positions,
                           std::span<const TriangleSide> sides, OutlineList& outlines) {
  const Status status = outlines.check(triangles, neighbours, positions, sides);
  if (!ok(status)) return status;
  const std::size_t first = 3 * count_;
  CurveFinder finder(vertices, triangles, positions, outlines.free_memory(), positions_.subspan(first),
                     normals_.subspan(first));
  detail::EdgeFinder<CurveFinder>(triangles, sides, finder).find(neighbours.bytes());
  if (!outlines.take(finder.edge_count(), positions.viewport())) return Status::kBufferTooSmall;
  count_ += finder.curve_count();
  for (std::size_t i = first; i < 3 * count_; ++i) indices_[i] = static_cast<std::uint16_t>(i);
  return finder.status();
}

MeshView CurvedOutlines::mesh(std::size_t first, std::size_t end) const {
  if (end > count_) end = count_;
  if (first >= end) return {};
  // Vertices are counted from the first one, so that the indices are the same wherever it is.
  const std::size_t vertices = 3 * (end - first);
  const std::span<const ObjectPosition> positions = positions_.subspan(3 * first, vertices);
  const std::span<const PackedNormal> normals = normals_.subspan(3 * first, vertices);
  const std::span<const std::uint16_t> indices = indices_.first(vertices);
  MeshView made;
  (void)MeshView::make(positions, normals, indices, made);
  return made;
}

}  // namespace arcspan
