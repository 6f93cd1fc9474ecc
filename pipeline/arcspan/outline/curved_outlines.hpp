// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/mesh/packed_normal.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan {

/// Memory for the curves of a frame, 36 bytes each; contents before do not matter.
template <std::size_t kMost>
struct CurveMemory {
  static_assert(std::uint32_t{3} * kMost <= MeshView::kMaxVertices, "at most 21845 curves");

  std::array<ObjectPosition, 3 * kMost> positions{};
  std::array<PackedNormal, 3 * kMost> normals{};
  std::array<std::uint16_t, 3 * kMost> indices{};
};

namespace detail {

/// A vertex as it is drawn: its position in object space, its normal as stored and as a unit vector.
struct DrawnVertex {
  ObjectPosition position;
  PackedNormal packed;
  Direction normal;
};

/// The vertices of a mesh of any type. The mesh must outlive this. Operator [] needs exist().
class DrawnVertices {
 public:
  /// There are none: exist() is false.
  constexpr DrawnVertices() = default;
  template <DrawableMesh Mesh>
  explicit constexpr DrawnVertices(const Mesh& mesh) : mesh_(&mesh), vertex_(&vertex_of<Mesh>) {}

  [[nodiscard]] constexpr bool exist() const { return mesh_ != nullptr; }
  [[nodiscard]] DrawnVertex operator[](std::size_t i) const { return vertex_(mesh_, i); }

 private:
  template <class Mesh>
  [[nodiscard]] static DrawnVertex vertex_of(const void* address, std::size_t i) {
    const Mesh& mesh = *static_cast<const Mesh*>(address);
    const Direction normal = mesh.direction(i);
    if constexpr (std::is_same_v<Mesh, MeshView>) {
      return {mesh.position(i), mesh.normal(i), normal};
    } else {
      return {mesh.position(i), pack_normal(normal.x.raw(), normal.y.raw(), normal.z.raw()), normal};
    }
  }

  const void* mesh_ = nullptr;
  DrawnVertex (*vertex_)(const void* mesh, std::size_t i) = nullptr;
};

}  // namespace detail

/// Rounds the outlines of coarse meshes with smooth normals: outside of each edge at which the surface turns
/// away lies a triangle, from the edge to the middle of a curve over it. They are a mesh of their own, which
/// is drawn like the object, after or before it, with the same transform, lighting and depth buffer:
///
///     CurvedOutlines curves(memory);
///     status = curves.add(mesh, neighbours, positions, sides, outlines);  // instead of outlines.add()
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
  explicit constexpr CurvedOutlines(CurveMemory<kMost>& memory)
      : CurvedOutlines(memory.positions, memory.normals, memory.indices) {}
  /// The same over three arrays, with three elements of each per curve: as many curves as the shortest array
  /// holds, at most 21845.
  constexpr CurvedOutlines(std::span<ObjectPosition> positions, std::span<PackedNormal> normals,
                           std::span<std::uint16_t> indices)
      : positions_(positions.first(
            least(least(positions.size(), normals.size()), least(indices.size(), kMostVertices)))),
        normals_(normals),
        indices_(indices) {}

  /// Forgets the curves, for the next frame.
  constexpr void clear() { count_ = 0; }

  /// Adds the curves of an object, and its outlines with them to `outlines`. The arguments are those of
  /// OutlineList::add(), but `mesh` may also pose its vertices: `positions` are then those of its cache.
  /// Returns kOk, or
  ///
  ///   kScaleOutOfRange  the middle of a curve does not fit 16 bits: its edge stays straight
  ///   kBufferTooSmall   the memory does not hold all curves: the edges of the others stay straight. Or
  ///                     `outlines` does not hold all edges: nothing is added
  ///   others            those of OutlineList::add(): nothing is added
  template <DrawableMesh Mesh>
  Status add(const Mesh& mesh, const MeshNeighbours& neighbours, const VertexPositions& positions,
             std::span<const TriangleSide> sides, OutlineList& outlines) {
    return add(detail::DrawnVertices(mesh), mesh.view(), neighbours, positions, sides, outlines);
  }

  [[nodiscard]] constexpr std::size_t count() const { return count_; }
  /// The triangles of all curves, or of those from `first` to `end` - 1 as far as they exist. It stays valid
  /// until clear().
  [[nodiscard]] MeshView mesh() const { return mesh(0, count_); }
  [[nodiscard]] MeshView mesh(std::size_t first, std::size_t end) const;

  /// @cond for add() and find_outlines(), not in the reference
  Status add(const detail::DrawnVertices& vertices, const MeshView& triangles,
             const MeshNeighbours& neighbours, const VertexPositions& positions,
             std::span<const TriangleSide> sides, OutlineList& outlines);
  /// @endcond

 private:
  static constexpr std::size_t kMostVertices = 65535;

  [[nodiscard]] static constexpr std::size_t least(std::size_t a, std::size_t b) { return a < b ? a : b; }

  std::span<ObjectPosition> positions_;
  std::span<PackedNormal> normals_;
  std::span<std::uint16_t> indices_;
  std::size_t count_ = 0;
};

}  // namespace arcspan
