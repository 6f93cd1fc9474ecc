// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/packed_normal.hpp>
#include <arcspan/status.hpp>

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

/// A triangle mesh in memory of the caller (flash, as a rule): nothing is copied, 10 bytes a vertex and 3 or
/// 6 bytes a triangle. Vertex i has positions[i] and normals[i].
class MeshView {
 public:
  static constexpr std::uint32_t kMaxVertices = 65536;

  constexpr MeshView() = default;

  /// A view of the given arrays, checked once so that drawing need not: kInvalidArgument if the number of
  /// normals is not that of positions, the number of indices no multiple of 3, or there are more than
  /// kMaxVertices; kIndexOutOfRange if an index names no vertex. `view` is untouched unless kOk.
  static constexpr Status make(std::span<const ObjectPosition> positions,
                               std::span<const PackedNormal> normals, std::span<const std::uint16_t> indices,
                               MeshView& view);
  static constexpr Status make(std::span<const ObjectPosition> positions,
                               std::span<const PackedNormal> normals, std::span<const std::uint8_t> indices,
                               MeshView& view);

  /// The same as a constant: arrays that make() would refuse do not compile.
  [[nodiscard]] static consteval MeshView of(std::span<const ObjectPosition> positions,
                                             std::span<const PackedNormal> normals,
                                             std::span<const std::uint16_t> indices) {
    MeshView view;
    if (!ok(make(positions, normals, indices, view))) detail::constant_refused();
    return view;
  }
  [[nodiscard]] static consteval MeshView of(std::span<const ObjectPosition> positions,
                                             std::span<const PackedNormal> normals,
                                             std::span<const std::uint8_t> indices) {
    MeshView view;
    if (!ok(make(positions, normals, indices, view))) detail::constant_refused();
    return view;
  }

  [[nodiscard]] constexpr std::size_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] constexpr std::size_t triangle_count() const { return triangle_count_; }

  /// `i` must be below vertex_count().
  [[nodiscard]] constexpr const ObjectPosition& position(std::size_t i) const { return positions_[i]; }
  [[nodiscard]] constexpr PackedNormal normal(std::size_t i) const { return normals_[i]; }

  /// `i` must be below triangle_count().
  [[nodiscard]] constexpr TriangleIndices triangle(std::size_t i) const {
    if (indices8_ != nullptr) {
      const std::uint8_t* at = indices8_ + 3 * i;
      return {at[0], at[1], at[2]};
    }
    const std::uint16_t* at = indices16_ + 3 * i;
    return {at[0], at[1], at[2]};
  }

 private:
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
};

namespace detail {

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

}  // namespace arcspan
