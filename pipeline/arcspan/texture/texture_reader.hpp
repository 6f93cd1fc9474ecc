// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/status.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

/// How texture binaries are read, by themselves and as chunks of a model binary.
namespace arcspan::detail {

/// Reads a sampler_byte(); false if it is none.
[[nodiscard]] inline bool read_sampler(std::uint8_t byte, TextureSampler& sampler) {
  const unsigned u = byte & 3u;
  const unsigned v = (byte >> 2) & 3u;
  constexpr auto kMost = static_cast<unsigned>(TextureWrap::kMirror);
  if (u > kMost || v > kMost || byte >> 5 != 0) return false;
  sampler = {static_cast<TextureWrap>(u), static_cast<TextureWrap>(v),
             static_cast<TextureFilter>((byte >> 4) & 1u)};
  return true;
}

/// Reads what the header says of the texture; false if there is no such texture.
[[nodiscard]] inline bool read_texture_format(const std::uint8_t* header, StoredTexture& texture) {
  const std::uint8_t texels = header[texture_binary::kLayoutAt];
  texture.alpha_bits = header[texture_binary::kAlphaBitsAt];
  texture.size = {header[texture_binary::kWidthBitsAt], header[texture_binary::kHeightBitsAt],
                  header[texture_binary::kLevelsAt]};
  if (texels > static_cast<std::uint8_t>(TexelLayout::kGray)) return false;
  texture.layout = static_cast<TexelLayout>(texels);
  if (!read_sampler(header[texture_binary::kSamplerAt], texture.sampler)) return false;
  const bool has_alpha = texture.alpha_bits == 1 || texture.alpha_bits == 4;
  return (texture.alpha_bits == 0 || (has_alpha && texture.layout != TexelLayout::kGray)) &&
         texture.size.valid();
}

/// Reads and checks the header of a texture that ends with `checksum` bytes. `texture` is without its arrays.
[[nodiscard]] inline Status read_texture_header(std::span<const std::uint8_t> bytes, std::uint32_t checksum,
                                                StoredTexture& texture) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* const at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= texture_binary::kVersionAt &&
      little_u32(at + texture_binary::kMagicAt) != texture_binary::kMagic)
    return Status::kUnsupported;
  if (bytes.size() < texture_binary::kHeaderBytes + checksum) return Status::kTruncated;
  if (little_u16(at + texture_binary::kVersionAt) != texture_binary::kVersion) return Status::kUnsupported;
  const std::uint32_t size = little_u32(at + texture_binary::kSizeAt);
  if (!read_texture_format(at, texture) ||
      size - checksum !=
          texture_binary::bytes(texture.layout, texture.size) - std::uint32_t{texture_binary::kChecksumBytes})
    return Status::kCorrupted;
  return bytes.size() < size ? Status::kTruncated : Status::kOk;
}

/// Adds the arrays of a binary whose header has been read.
inline void find_texture_arrays(const std::uint8_t* binary, StoredTexture& texture) {
  const auto colours = static_cast<std::size_t>(texture_binary::palette_size(texture.layout));
  texture.palette = {elements_at<std::uint16_t>(binary + texture_binary::kHeaderBytes), colours};
  texture.texels = {binary + texture_binary::kHeaderBytes + 2 * colours,
                    static_cast<std::size_t>(texture_binary::texel_bytes(texture.layout, texture.size))};
}

}  // namespace arcspan::detail
