// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// An edge of a triangle that is an outline on the screen. The triangle lies on the left of the way `from` ->
/// `to`, as seen by one who goes along it: right of an edge that leads down.
struct OutlineEdge {
  RasterPosition from;
  RasterPosition to;
};

/// Where the vertices of a mesh are on the screen.
class VertexPositions {
 public:
  /// Each vertex is transformed when it is asked for.
  explicit constexpr VertexPositions(const ClipTransform& transform)
      : transform_(&transform), count_(SIZE_MAX) {}
  /// Those of the vertices in the memory of a VertexCache that was used with `transform`, to draw the mesh or
  /// to find its sides. Vertices that only hidden triangles have may be missing there: they are transformed.
  template <class Method>
  VertexPositions(const ClipTransform& transform, std::span<const CachedVertex<Method>> vertices)
      : transform_(&transform), count_(vertices.size()), stride_(sizeof(CachedVertex<Method>)) {
    if (vertices.empty()) return;
    cached_ = bytes_of(vertices.front().raster.position);
    outcodes_ = bytes_of(vertices.front().outcode);
    static_assert(CachedVertex<Method>::kNotTransformed == kNotTransformed);
  }

  /// The position of vertex `i` of a mesh, which must be below count() and inside the clip volume.
  [[nodiscard]] RasterPosition operator()(const MeshView& mesh, std::size_t i) const {
    RasterPosition position;
    take(mesh, i, position);
    return position;
  }
  /// Sets `position` to it.
  void take(const MeshView& mesh, std::size_t i, RasterPosition& position) const {
    if (cached_ == nullptr || outcodes_[i * stride_] == kNotTransformed) return transform(mesh, i, position);
    position = *static_cast<const RasterPosition*>(static_cast<const void*>(cached_ + i * stride_));
  }
  /// The number of vertices whose positions are there.
  [[nodiscard]] constexpr std::size_t count() const { return count_; }
  [[nodiscard]] constexpr const Viewport& viewport() const { return transform_->viewport(); }
  [[nodiscard]] constexpr const ClipTransform& transform() const { return *transform_; }

 private:
  static constexpr std::uint8_t kNotTransformed = 0xFF;  ///< as in every CachedVertex

  void transform(const MeshView& mesh, std::size_t i, RasterPosition& position) const;
  template <class T>
  [[nodiscard]] static const std::uint8_t* bytes_of(const T& member) {
    return static_cast<const std::uint8_t*>(static_cast<const void*>(&member));
  }

  const ClipTransform* transform_;
  const std::uint8_t* cached_ = nullptr;  ///< the first position, or null
  const std::uint8_t* outcodes_ = nullptr;
  std::size_t count_;
  std::size_t stride_ = 0;  ///< bytes from one to the next
};

class CurvedOutlines;

/// The outlines of the objects of a frame, in memory of the caller: 12 bytes per edge. They are found once
/// per frame, after or before the objects are drawn, and smoothed in each band.
class OutlineList {
 public:
  constexpr explicit OutlineList(std::span<OutlineEdge> memory) : memory_(memory) {}

  /// Forgets the edges, for the next frame.
  constexpr void clear() { count_ = 0; }

  /// Adds the outlines of an object: edges of seen triangles beyond which there is no triangle, one that is
  /// not seen, or one whose other side is seen, and creases between seen triangles. Triangles that are kCut
  /// have none. All objects of a frame have transforms of the same viewport.
  ///
  /// `sides` are those of NotedSides or find_sides() for the same mesh and the transform of `positions`.
  /// Returns kOk, or adds nothing and returns:
  ///
  ///   kUnsupported       the mesh has no neighbours: the view was never made
  ///   kInvalidArgument   the neighbours are those of another number of triangles, `sides` or positions are
  ///                      too few, or the viewport is not that of earlier objects
  ///   kBufferTooSmall    the memory does not hold the edges of all objects so far
  Status add(const MeshView& mesh, const MeshNeighbours& neighbours, const VertexPositions& positions,
             std::span<const TriangleSide> sides);

  [[nodiscard]] constexpr std::span<const OutlineEdge> edges() const { return memory_.first(count_); }
  /// The viewport of the objects; meaningless if there are no edges.
  [[nodiscard]] constexpr const Viewport& viewport() const { return viewport_; }
  /// A rectangle, in pixels of the picture, around all that smoothing and ink of this width change
  /// (OutlineInk::width; 0: no ink). Pixels of CurvedOutlines lie within this and drawn_rect() together
  /// (bounding_rect()). Rect{} if no edges are in the picture.
  [[nodiscard]] Rect changed_rect(std::uint8_t ink_width) const;

 private:
  friend class CurvedOutlines;

  /// Whether these may be the arguments of add().
  [[nodiscard]] Status check(const MeshView& mesh, const MeshNeighbours& neighbours,
                             const VertexPositions& positions, std::span<const TriangleSide> sides) const;
  [[nodiscard]] constexpr std::span<OutlineEdge> free_memory() const { return memory_.subspan(count_); }
  /// Takes edges that were written to free_memory(), if it holds so many.
  [[nodiscard]] constexpr bool take(std::size_t count, const Viewport& viewport) {
    if (count > memory_.size() - count_) return false;
    viewport_ = viewport;
    count_ += count;
    return true;
  }

  std::span<OutlineEdge> memory_;
  std::size_t count_ = 0;
  Viewport viewport_{};
};

}  // namespace arcspan
