// SPDX-License-Identifier: MIT
#include <arcspan/model/model_neighbours.hpp>

namespace arcspan {

Status view_neighbours(const StoredModel& model, std::size_t i, MeshNeighbours& neighbours) {
  const std::span<const std::uint8_t> bytes =
      model.chunks().find(model_binary::kNeighboursTag, static_cast<std::uint32_t>(i));
  if (bytes.data() == nullptr) return Status::kUnsupported;
  return MeshNeighbours::make(model.part(i).mesh, bytes, neighbours);
}

}  // namespace arcspan
