// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/texture/texture_binary.hpp>
#include <arcspan/texture/texture_reader.hpp>

namespace arcspan {

Status view_texture_binary(std::span<const std::uint8_t> bytes, StoredTexture& texture) {
  StoredTexture found;
  const Status status = detail::read_texture_header(bytes, texture_binary::kChecksumBytes, found);
  if (!ok(status)) return status;
  // Sizes fit std::size_t, because the whole binary is in memory.
  const std::size_t covered = static_cast<std::size_t>(little_u32(bytes.data() + texture_binary::kSizeAt)) -
                              texture_binary::kChecksumBytes;
  if (crc32(bytes.first(covered)) != little_u32(bytes.data() + covered)) return Status::kCorrupted;
  detail::find_texture_arrays(bytes.data(), found);
  texture = found;
  return Status::kOk;
}

}  // namespace arcspan
