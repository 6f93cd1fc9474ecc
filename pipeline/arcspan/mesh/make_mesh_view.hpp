// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

/// The checks of MeshView.
namespace arcspan {

namespace detail {

/// The squared distance of a vertex from the object's origin, at most 3 * 2^30.
[[nodiscard]] constexpr std::uint32_t squared_distance(const ObjectPosition& p) {
  const auto square = [](std::int32_t c) { return static_cast<std::uint32_t>(c * c); };
  return square(p.x) + square(p.y) + square(p.z);
}

/// The checks of MeshView::make().
template <class Index>
[[nodiscard]] constexpr Status check_mesh(std::size_t positions, std::size_t normals,
                                          std::span<const Index> indices) {
  if (positions != normals || positions > MeshView::kMaxVertices || indices.size() % 3 != 0) {
    return Status::kInvalidArgument;
  }
  for (const Index index : indices) {
    if (index >= positions) return Status::kIndexOutOfRange;
  }
  return Status::kOk;
}

}  // namespace detail

constexpr Status MeshView::make(std::span<const ObjectPosition> positions,
                                std::span<const PackedNormal> normals, std::span<const std::uint16_t> indices,
                                MeshView& view) {
  const Status status = detail::check_mesh(positions.size(), normals.size(), indices);
  if (!ok(status)) return status;
  view = MeshView(positions, normals, indices.size() / 3);
  view.indices16_ = indices.data();
  return Status::kOk;
}

constexpr Status MeshView::make(std::span<const ObjectPosition> positions,
                                std::span<const PackedNormal> normals, std::span<const std::uint8_t> indices,
                                MeshView& view) {
  const Status status = detail::check_mesh(positions.size(), normals.size(), indices);
  if (!ok(status)) return status;
  view = MeshView(positions, normals, indices.size() / 3);
  view.indices8_ = indices.data();
  return Status::kOk;
}

constexpr Status MeshView::attach(std::span<const FacePlane> planes, const PlaneScale& scale) {
  if (planes.size() != triangle_count_ || !scale.valid()) return Status::kInvalidArgument;
  const std::uint32_t radius = scale.radius;
  for (std::size_t i = 0; i < vertex_count_; ++i) {
    if (detail::squared_distance(positions_[i]) > radius * radius) return Status::kInvalidArgument;
  }
  planes_ = planes.data();
  plane_scale_ = scale;
  return Status::kOk;
}

constexpr Status MeshView::attach(std::span<const TexturePoint> points, const TextureScale& scale) {
  if (points.size() != vertex_count_ || scale.fraction_bits < TextureScale::kLeastBits ||
      scale.fraction_bits > TextureScale::kMostBits) {
    return Status::kInvalidArgument;
  }
  texture_points_ = points.data();
  texture_scale_ = scale;
  return Status::kOk;
}

constexpr Status MeshView::attach(std::span<const Rgb8> colours) {
  if (colours.size() != vertex_count_) return Status::kInvalidArgument;
  colours_ = colours.data();
  return Status::kOk;
}

}  // namespace arcspan
