// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/mesh/mesh_reader.hpp>
#include <arcspan/numbers/little_endian.hpp>

namespace arcspan {

namespace {

ObjectPosition position_at(const std::uint8_t* bytes, std::size_t at) {
  return {static_cast<std::int16_t>(little_u16(bytes + at)),
          static_cast<std::int16_t>(little_u16(bytes + at + 2)),
          static_cast<std::int16_t>(little_u16(bytes + at + 4))};
}

}  // namespace

Status view_mesh_binary(std::span<const std::uint8_t> bytes, MeshView& view, MeshBounds* bounds) {
  detail::MeshHeader header{};
  Status status = detail::read_mesh_header(bytes, mesh_binary::kChecksumBytes, header);
  if (!ok(status)) return status;
  const std::size_t covered = static_cast<std::size_t>(header.size) - mesh_binary::kChecksumBytes;
  if (crc32(bytes.first(covered)) != little_u32(bytes.data() + covered)) return Status::kCorrupted;
  MeshView found;
  status = detail::MeshArrays(header, bytes.data()).check(found);
  if (!ok(status)) return status;
  view = found;
  if (bounds != nullptr) {
    *bounds = {position_at(bytes.data(), mesh_binary::kLowAt),
               position_at(bytes.data(), mesh_binary::kHighAt)};
  }
  return Status::kOk;
}

}  // namespace arcspan
