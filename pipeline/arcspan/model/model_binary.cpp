// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <bit>

namespace arcspan {

namespace {

namespace layout = model_binary;

/// Reads one value per channel; false if one is above 1.
bool read_channels(const std::uint8_t* at, ChannelCoefficients& channels) {
  constexpr std::uint16_t kWhole = 1u << Coefficient::kFraction;
  if (little_u16(at) > kWhole || little_u16(at + 2) > kWhole || little_u16(at + 4) > kWhole) return false;
  channels = {Coefficient::from_raw(little_u16(at)), Coefficient::from_raw(little_u16(at + 2)),
              Coefficient::from_raw(little_u16(at + 4))};
  return true;
}

struct Overview {
  std::size_t parts;
  std::size_t part_bytes;  ///< of an entry
};

/// Reads and checks all that the header says; its parts are checked one by one afterwards.
Status read_header(std::span<const std::uint8_t> bytes, Overview& overview) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= layout::kVersionAt && little_u32(at + layout::kMagicAt) != layout::kMagic)
    return Status::kUnsupported;
  if (bytes.size() < layout::kHeaderBytes) return Status::kTruncated;
  const std::uint16_t version = little_u16(at + layout::kVersionAt);
  if (version != layout::kVersion && version != layout::kVersionOfTextures) return Status::kUnsupported;
  const std::size_t part_bytes =
      version == layout::kVersion ? layout::kPartBytes : layout::kTexturedPartBytes;
  const std::size_t parts = little_u16(at + layout::kPartsAt);
  const auto covered =  // below 2^22, for which std::size_t may be too short
      static_cast<std::uint32_t>(layout::kHeaderBytes) +
      static_cast<std::uint32_t>(parts) * static_cast<std::uint32_t>(part_bytes);
  const std::uint32_t size = little_u32(at + layout::kSizeAt);
  if (size < covered + layout::kChecksumBytes) return Status::kCorrupted;
  if (bytes.size() < size) return Status::kTruncated;
  if (crc32(bytes.first(static_cast<std::size_t>(covered))) != little_u32(at + covered))
    return Status::kCorrupted;
  overview = {parts, part_bytes};
  return Status::kOk;
}

/// The bytes that two numbers of an entry, offset and size, name; false if they are not within the binary.
bool read_range(std::span<const std::uint8_t> binary, const std::uint8_t* at,
                std::span<const std::uint8_t>& range) {
  const std::uint32_t begin = little_u32(at);
  const std::uint32_t size = little_u32(at + 4);
  if (begin % 2 != 0 || begin > binary.size() || size > binary.size() - begin) return false;
  // Both are within the binary, so they fit std::size_t, which may have 16 bits.
  range = binary.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(size));
  return true;
}

bool read_material(const std::uint8_t* entry, Material& material) {
  const std::uint16_t shininess = little_u16(entry + layout::kShininessAt);
  material.shininess = shininess;
  return read_channels(entry + layout::kAmbientAt, material.ambient) &&
         read_channels(entry + layout::kDiffuseAt, material.diffuse) &&
         read_channels(entry + layout::kSpecularAt, material.specular) && shininess >= 1 && shininess <= 256;
}

/// Reads the texture of an entry of version 2.
Status read_texture(std::span<const std::uint8_t> binary, const std::uint8_t* entry, ModelPart& part) {
  const std::uint16_t flags = little_u16(entry + layout::kFlagsAt);
  if ((flags & layout::kMasked) != 0) part.alpha = PartAlpha::kMasked;
  if ((flags & layout::kBlended) != 0) part.alpha = PartAlpha::kBlended;
  if (little_u32(entry + layout::kTextureAt) == 0) return Status::kOk;
  std::span<const std::uint8_t> bytes;
  if (!read_range(binary, entry + layout::kTextureAt, bytes)) return Status::kCorrupted;
  return view_texture_binary(bytes, part.texture);
}

Status read_part(std::span<const std::uint8_t> binary, const std::uint8_t* entry, bool textured,
                 ModelPart& part) {
  part = {};
  std::span<const std::uint8_t> bytes;
  const std::uint16_t flags = little_u16(entry + layout::kFlagsAt);
  if (!read_range(binary, entry + layout::kMeshAt, bytes) || !read_material(entry, part.material) ||
      flags >= 2 * (textured ? layout::kBlended : layout::kTwoSided) ||
      entry[layout::kNameAt + layout::kNameBytes - 1] != 0) {
    return Status::kCorrupted;
  }
  // Cast by way of void, because signedness of characters does not matter.
  const void* name = entry + layout::kNameAt;
  part.name = static_cast<const char*>(name);
  part.two_sided = (flags & layout::kTwoSided) != 0;
  Status status = view_mesh_binary(bytes, part.mesh);
  if (ok(status) && textured) status = read_texture(binary, entry, part);
  // A mesh or texture that is cut short within a whole file is a fault of the file.
  return status == Status::kTruncated ? Status::kCorrupted : status;
}

}  // namespace

Status view_model_binary(std::span<const std::uint8_t> bytes, std::span<ModelPart> parts,
                         std::size_t& count) {
  Overview overview{};
  const Status status = read_header(bytes, overview);
  if (!ok(status)) return status;
  const std::size_t found = overview.parts;
  count = found;
  if (found > parts.size()) return Status::kBufferTooSmall;
  const std::span<const std::uint8_t> binary =
      bytes.first(static_cast<std::size_t>(little_u32(bytes.data() + layout::kSizeAt)));
  for (std::size_t i = 0; i < found; ++i) {
    const std::uint8_t* entry = bytes.data() + layout::kHeaderBytes + i * overview.part_bytes;
    const Status read = read_part(binary, entry, overview.part_bytes == layout::kTexturedPartBytes, parts[i]);
    if (!ok(read)) return read;
  }
  return Status::kOk;
}

}  // namespace arcspan
