// SPDX-License-Identifier: MIT
#include <arcspan/mesh/mesh_view.hpp>

namespace arcspan {

namespace {

template <class Index>
Status check(std::size_t positions, std::size_t normals, std::span<const Index> indices) {
  if (positions != normals || positions > MeshView::kMaxVertices || indices.size() % 3 != 0) {
    return Status::kInvalidArgument;
  }
  for (const Index index : indices) {
    if (index >= positions) return Status::kIndexOutOfRange;
  }
  return Status::kOk;
}

}  // namespace

Status MeshView::make(std::span<const ObjectPosition> positions, std::span<const PackedNormal> normals,
                      std::span<const std::uint16_t> indices, MeshView& view) {
  const Status status = check(positions.size(), normals.size(), indices);
  if (!ok(status)) return status;
  view.positions_ = positions.data();
  view.normals_ = normals.data();
  view.indices8_ = nullptr;
  view.indices16_ = indices.data();
  view.vertex_count_ = positions.size();
  view.triangle_count_ = indices.size() / 3;
  return Status::kOk;
}

Status MeshView::make(std::span<const ObjectPosition> positions, std::span<const PackedNormal> normals,
                      std::span<const std::uint8_t> indices, MeshView& view) {
  const Status status = check(positions.size(), normals.size(), indices);
  if (!ok(status)) return status;
  view.positions_ = positions.data();
  view.normals_ = normals.data();
  view.indices8_ = indices.data();
  view.indices16_ = nullptr;
  view.vertex_count_ = positions.size();
  view.triangle_count_ = indices.size() / 3;
  return Status::kOk;
}

}  // namespace arcspan
