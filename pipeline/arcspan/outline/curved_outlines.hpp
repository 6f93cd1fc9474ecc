// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// Memory for the curves of one object, 36 bytes each; contents before do not matter.
template <std::size_t kMost>
struct CurveMemory {
  static_assert(std::uint32_t{3} * kMost <= MeshView::kMaxVertices, "at most 21845 curves");

  std::array<ObjectPosition, 3 * kMost> positions{};
  std::array<PackedNormal, 3 * kMost> normals{};
  std::array<std::uint16_t, 3 * kMost> indices{};
};

/// Rounds the outlines of a coarse mesh with smooth normals: outside of each edge at which the surface turns
/// away lies a triangle, from the edge to the middle of a curve over it. They are a mesh of their own, which
/// is drawn like the object, after or before it, with the same transform, lighting and depth buffer:
///
///     CurvedOutlines curves(memory);
///     status = curves.find(mesh, neighbours, positions, sides, outlines);  // instead of outlines.add()
///     ...
///     draw_mesh<Method>(curves.mesh(), transform, light, band, depth);
///
/// The edge is shared exactly, so that no cracks show. Borders and creases stay straight, as do edges whose
/// normals are more than 72 degrees apart, and those over which the curve would rise by less than an eighth
/// of a pixel. Curves have neither texture points nor vertex colours.
///
/// The middle is that of a cubic curve that is perpendicular to the normals at both ends (Vlachos et al.,
/// "Curved PN Triangles", 2001).
class CurvedOutlines {
 public:
  template <std::size_t kMost>
  explicit CurvedOutlines(CurveMemory<kMost>& memory)
      : positions_(memory.positions), normals_(memory.normals), indices_(memory.indices) {}

  /// Finds the curves of an object, instead of those before, and adds its outlines with them to `outlines`.
  /// The arguments are those of OutlineList::add(). Returns kOk, or
  ///
  ///   kScaleOutOfRange  the middle of a curve does not fit 16 bits: its edge stays straight
  ///   kBufferTooSmall   the memory does not hold all curves: the edges of the others stay straight. Or
  ///                     `outlines` does not hold all edges: nothing is added, and there are no curves
  ///   others            those of OutlineList::add(): nothing is added, and there are no curves
  Status find(const MeshView& mesh, const MeshNeighbours& neighbours, const VertexPositions& positions,
              std::span<const TriangleSide> sides, OutlineList& outlines);

  /// The triangles of the curves. It stays valid until the next find().
  [[nodiscard]] const MeshView& mesh() const { return mesh_; }

 private:
  std::span<ObjectPosition> positions_;
  std::span<PackedNormal> normals_;
  std::span<std::uint16_t> indices_;
  MeshView mesh_{};
};

}  // namespace arcspan
