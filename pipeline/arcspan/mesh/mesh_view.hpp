// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/face_plane.hpp>
#include <arcspan/mesh/packed_normal.hpp>
#include <arcspan/mesh/texture_point.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A vertex position in object units: any 16-bit value.
struct ObjectPosition {
  std::int16_t x = 0;
  std::int16_t y = 0;
  std::int16_t z = 0;

  friend constexpr bool operator==(const ObjectPosition&, const ObjectPosition&) = default;
};

/// The three vertices of a triangle, counter-clockwise seen from the front.
struct TriangleIndices {
  std::uint16_t a = 0;
  std::uint16_t b = 0;
  std::uint16_t c = 0;
};

namespace detail {

struct MeshArrays;  // mesh_reader.hpp

/// The squared distance of a vertex from the object's origin, at most 3 * 2^30.
[[nodiscard]] constexpr std::uint32_t squared_distance(const ObjectPosition& p) {
  const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };
  return square(p.x) + square(p.y) + square(p.z);
}

inline constexpr std::uint32_t kMostVertices = 65536;

/// The checks of MeshView::make().
template <class Index>
[[nodiscard]] constexpr Status check_mesh(std::size_t positions, std::size_t normals,
                                          std::span<const Index> indices) {
  if (positions != normals || positions > kMostVertices || indices.size() % 3 != 0) {
    return Status::kInvalidArgument;
  }
  for (const Index index : indices) {
    if (index >= positions) return Status::kIndexOutOfRange;
  }
  return Status::kOk;
}

// The reasons of MeshView::of() and with().
namespace refused {
void positions_and_normals_differ_in_number();
void more_than_65536_vertices();
void indices_not_a_multiple_of_3();
void planes_not_as_many_as_triangles();
void plane_scale_out_of_range();
void vertex_beyond_radius_of_planes();
void texture_points_not_as_many_as_vertices();
void texture_scale_out_of_range();
void colours_not_as_many_as_vertices();
}  // namespace refused

/// Rejects a mesh unless `status`, that of MeshView::make(), is kOk.
constexpr void refuse_mesh(Status status, std::size_t positions, std::size_t normals) {
  if (ok(status)) return;
  if (status != Status::kInvalidArgument) return refuse(status);
  if (positions != normals) return refused::positions_and_normals_differ_in_number();
  if (std::uint64_t{positions} > kMostVertices) return refused::more_than_65536_vertices();
  if (status == Status::kInvalidArgument) refused::indices_not_a_multiple_of_3();
}

constexpr void refuse_planes(bool as_many_as_triangles, const PlaneScale& scale) {
  if (!as_many_as_triangles) refused::planes_not_as_many_as_triangles();
  if (!scale.valid()) refused::plane_scale_out_of_range();
  if (scale.valid()) refused::vertex_beyond_radius_of_planes();
}

constexpr void refuse_points(bool as_many_as_vertices) {
  if (!as_many_as_vertices) refused::texture_points_not_as_many_as_vertices();
  if (as_many_as_vertices) refused::texture_scale_out_of_range();
}

}  // namespace detail

/// A view of a triangle mesh in the caller's memory, usually flash, which must outlive it. Nothing is copied.
/// A mesh takes 10 bytes per vertex and 3 or 6 bytes per triangle. Vertex i has positions[i] and normals[i].
class MeshView {
 public:
  static constexpr std::uint32_t kMaxVertices = 65536;
  static_assert(kMaxVertices == detail::kMostVertices);

  constexpr MeshView() = default;

  /// Equal views refer to the same arrays.
  friend constexpr bool operator==(const MeshView&, const MeshView&) = default;

  /// Makes a view of arrays of vertices and of triangles, each three indices. They are checked here once, so
  /// that drawing need not. Returns:
  ///
  ///   kOk                `view` is set; otherwise it is not changed
  ///   kInvalidArgument   the numbers of positions and normals differ or exceed kMaxVertices, or the
  ///                      number of indices is no multiple of 3
  ///   kIndexOutOfRange   an index names no vertex
  static constexpr Status make(std::span<const ObjectPosition> positions,
                               std::span<const PackedNormal> normals, std::span<const std::uint16_t> indices,
                               MeshView& view) {
    const Status status = detail::check_mesh(positions.size(), normals.size(), indices);
    if (!ok(status)) return status;
    view = MeshView(positions, normals, indices.size() / 3);
    view.indices16_ = indices.data();
    return Status::kOk;
  }
  static constexpr Status make(std::span<const ObjectPosition> positions,
                               std::span<const PackedNormal> normals, std::span<const std::uint8_t> indices,
                               MeshView& view) {
    const Status status = detail::check_mesh(positions.size(), normals.size(), indices);
    if (!ok(status)) return status;
    view = MeshView(positions, normals, indices.size() / 3);
    view.indices8_ = indices.data();
    return Status::kOk;
  }

  /// make() as a constant. Arrays that make() rejects do not compile.
  [[nodiscard]] static consteval MeshView of(std::span<const ObjectPosition> positions,
                                             std::span<const PackedNormal> normals,
                                             std::span<const std::uint16_t> indices) {
    MeshView view;
    detail::refuse_mesh(make(positions, normals, indices, view), positions.size(), normals.size());
    return view;
  }
  [[nodiscard]] static consteval MeshView of(std::span<const ObjectPosition> positions,
                                             std::span<const PackedNormal> normals,
                                             std::span<const std::uint8_t> indices) {
    MeshView view;
    detail::refuse_mesh(make(positions, normals, indices, view), positions.size(), normals.size());
    return view;
  }

  /// Attaches the planes of the mesh's triangles, 4 bytes each, made by make_face_planes(). When an object is
  /// wholly in view, its back faces are then culled before their vertices are transformed (BackFaces).
  ///
  /// Returns kInvalidArgument, and changes nothing, if the number of planes is not that of triangles, a
  /// member of `scale` is out of range, or a vertex is farther from the origin than scale.radius. The planes
  /// themselves are not checked; with wrong ones front faces are culled.
  constexpr Status attach(std::span<const FacePlane> planes, const PlaneScale& scale) {
    if (planes.size() != triangle_count_ || !scale.valid()) return Status::kInvalidArgument;
    const std::uint32_t radius = scale.radius;
    for (std::size_t i = 0; i < vertex_count_; ++i) {
      if (detail::squared_distance(positions_[i]) > radius * radius) return Status::kInvalidArgument;
    }
    planes_ = planes.data();
    plane_scale_ = scale;
    return Status::kOk;
  }
  /// A copy with attach() done, as a constant. Planes that attach() rejects do not compile.
  [[nodiscard]] consteval MeshView with(std::span<const FacePlane> planes, const PlaneScale& scale) const {
    MeshView view = *this;
    if (!ok(view.attach(planes, scale))) detail::refuse_planes(planes.size() == triangle_count_, scale);
    return view;
  }

  /// Attaches a texture point for each vertex, 4 bytes each. Returns kInvalidArgument, and changes nothing,
  /// if their number is not that of vertices or the scale is out of range. Without them all points are (0,
  /// 0).
  constexpr Status attach(std::span<const TexturePoint> points, const TextureScale& scale) {
    if (points.size() != vertex_count_ || scale.fraction_bits < TextureScale::kLeastBits ||
        scale.fraction_bits > TextureScale::kMostBits) {
      return Status::kInvalidArgument;
    }
    texture_points_ = points.data();
    texture_scale_ = scale;
    return Status::kOk;
  }
  /// A copy with attach() done, as a constant. Points that attach() rejects do not compile.
  [[nodiscard]] consteval MeshView with(std::span<const TexturePoint> points,
                                        const TextureScale& scale) const {
    MeshView view = *this;
    if (!ok(view.attach(points, scale))) detail::refuse_points(points.size() == vertex_count_);
    return view;
  }

  /// Attaches a colour for each vertex, 3 bytes each. Returns kInvalidArgument, and changes nothing, if their
  /// number is not that of vertices. Without them all vertices are white.
  constexpr Status attach(std::span<const Rgb8> colours) {
    if (colours.size() != vertex_count_) return Status::kInvalidArgument;
    colours_ = colours.data();
    return Status::kOk;
  }
  /// A copy with attach() done, as a constant. Colours that attach() rejects do not compile.
  [[nodiscard]] consteval MeshView with(std::span<const Rgb8> colours) const {
    MeshView view = *this;
    if (!ok(view.attach(colours))) detail::refused::colours_not_as_many_as_vertices();
    return view;
  }

  /// A view of `count` triangles from `first` on, with all vertices. What is beyond the last triangle is left
  /// out.
  [[nodiscard]] constexpr MeshView part(std::size_t first, std::size_t count) const {
    MeshView view = *this;
    const std::size_t begin = first < triangle_count_ ? first : triangle_count_;
    view.triangle_count_ = count < triangle_count_ - begin ? count : triangle_count_ - begin;
    if (indices8_ != nullptr) view.indices8_ += 3 * begin;
    if (indices16_ != nullptr) view.indices16_ += 3 * begin;
    if (planes_ != nullptr) view.planes_ += begin;
    return view;
  }

  /// The planes of the triangles, triangle_count() of them, or null.
  [[nodiscard]] constexpr const FacePlane* planes() const { return planes_; }
  [[nodiscard]] constexpr const PlaneScale& plane_scale() const { return plane_scale_; }

  [[nodiscard]] constexpr std::size_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] constexpr std::size_t triangle_count() const { return triangle_count_; }

  /// Position and normal of vertex `i`, which must be below vertex_count().
  [[nodiscard]] constexpr const ObjectPosition& position(std::size_t i) const { return positions_[i]; }
  [[nodiscard]] constexpr PackedNormal normal(std::size_t i) const { return normals_[i]; }
  /// normal(), unpacked.
  [[nodiscard]] Direction direction(std::size_t i) const { return unpack_normal(normals_[i]); }
  /// This view, for DrawableMesh.
  [[nodiscard]] constexpr const MeshView& view() const { return *this; }

  /// Texture point of vertex `i`, which must be below vertex_count().
  [[nodiscard]] constexpr TexturePoint texture_point(std::size_t i) const {
    return texture_points_ == nullptr ? TexturePoint{} : texture_points_[i];
  }
  [[nodiscard]] constexpr const TextureScale& texture_scale() const { return texture_scale_; }

  /// Colour of vertex `i`, which must be below vertex_count().
  [[nodiscard]] constexpr Rgb8 colour(std::size_t i) const {
    return colours_ == nullptr ? Rgb8{255, 255, 255} : colours_[i];
  }

  /// The vertices of triangle `i`, which must be below triangle_count().
  [[nodiscard]] ARCSPAN_INLINE constexpr TriangleIndices triangle(std::size_t i) const {
    if (indices8_ != nullptr) {
      const std::uint8_t* at = indices8_ + 3 * i;
      return {at[0], at[1], at[2]};
    }
    const std::uint16_t* at = indices16_ + 3 * i;
    return {at[0], at[1], at[2]};
  }
  /// The indices of all triangles; one of both is null.
  [[nodiscard]] constexpr const std::uint8_t* indices8() const { return indices8_; }
  [[nodiscard]] constexpr const std::uint16_t* indices16() const { return indices16_; }

 private:
  friend struct detail::MeshArrays;  // binaries, whose arrays have been checked

  constexpr MeshView(std::span<const ObjectPosition> positions, std::span<const PackedNormal> normals,
                     std::size_t triangle_count)
      : positions_(positions.data()),
        normals_(normals.data()),
        vertex_count_(positions.size()),
        triangle_count_(triangle_count) {}

  const ObjectPosition* positions_ = nullptr;
  const PackedNormal* normals_ = nullptr;
  const std::uint8_t* indices8_ = nullptr;
  const std::uint16_t* indices16_ = nullptr;
  std::size_t vertex_count_ = 0;
  std::size_t triangle_count_ = 0;
  const FacePlane* planes_ = nullptr;
  PlaneScale plane_scale_{};
  TextureScale texture_scale_{};
  const TexturePoint* texture_points_ = nullptr;
  const Rgb8* colours_ = nullptr;
};

}  // namespace arcspan
