// SPDX-License-Identifier: MIT
#include <arcspan/texture/texture_chunk.hpp>
#include <arcspan/texture/texture_reader.hpp>

namespace arcspan {

Status detail::check_texture_chunk(std::span<const std::uint8_t> bytes) {
  StoredTexture texture;
  const Status status = read_texture_header(bytes, 0, texture);
  if (status == Status::kTruncated ||
      (ok(status) && little_u32(bytes.data() + texture_binary::kSizeAt) != bytes.size()))
    return Status::kCorrupted;
  return status;
}

StoredTexture detail::texture_of_chunk(const std::uint8_t* bytes) {
  StoredTexture texture;
  (void)read_texture_format(bytes, texture);  // has been checked
  find_texture_arrays(bytes, texture);
  return texture;
}

}  // namespace arcspan
