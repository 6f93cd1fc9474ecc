// SPDX-License-Identifier: MIT
#include <arcspan/mesh/mesh_chunk.hpp>
#include <arcspan/mesh/mesh_reader.hpp>

namespace arcspan {

Status detail::check_mesh_chunk(std::span<const std::uint8_t> bytes) {
  MeshHeader header{};
  const Status status = read_mesh_header(bytes, 0, header);
  if (status == Status::kTruncated || (ok(status) && header.size != bytes.size())) return Status::kCorrupted;
  MeshView view;
  return ok(status) ? MeshArrays(header, bytes.data()).check(view) : status;
}

MeshView detail::mesh_of_chunk(const std::uint8_t* bytes) {
  return MeshArrays(mesh_header_at(bytes), bytes).checked_view();
}

}  // namespace arcspan
