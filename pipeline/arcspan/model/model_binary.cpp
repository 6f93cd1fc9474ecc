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

/// Reads and checks all that the header says; its parts are checked one by one afterwards.
Status read_header(std::span<const std::uint8_t> bytes, std::size_t& count) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= layout::kVersionAt && little_u32(at + layout::kMagicAt) != layout::kMagic)
    return Status::kUnsupported;
  if (bytes.size() < layout::kHeaderBytes) return Status::kTruncated;
  if (little_u16(at + layout::kVersionAt) != layout::kVersion) return Status::kUnsupported;
  const std::size_t parts = little_u16(at + layout::kPartsAt);
  const auto covered =  // below 2^22, for which std::size_t may be too short
      static_cast<std::uint32_t>(layout::kHeaderBytes) +
      static_cast<std::uint32_t>(parts) * static_cast<std::uint32_t>(layout::kPartBytes);
  const std::uint32_t size = little_u32(at + layout::kSizeAt);
  if (size < covered + layout::kChecksumBytes) return Status::kCorrupted;
  if (bytes.size() < size) return Status::kTruncated;
  if (crc32(bytes.first(static_cast<std::size_t>(covered))) != little_u32(at + covered))
    return Status::kCorrupted;
  count = parts;
  return Status::kOk;
}

Status read_part(std::span<const std::uint8_t> binary, const std::uint8_t* entry, ModelPart& part) {
  const std::uint32_t begin = little_u32(entry + layout::kMeshAt);
  const std::uint32_t size = little_u32(entry + layout::kMeshBytesAt);
  const std::uint16_t shininess = little_u16(entry + layout::kShininessAt);
  const std::uint16_t flags = little_u16(entry + layout::kFlagsAt);
  Material material;
  const bool is_right = begin % 2 == 0 && begin <= binary.size() && size <= binary.size() - begin &&
                        read_channels(entry + layout::kAmbientAt, material.ambient) &&
                        read_channels(entry + layout::kDiffuseAt, material.diffuse) &&
                        read_channels(entry + layout::kSpecularAt, material.specular) && shininess >= 1 &&
                        shininess <= 256 && flags <= layout::kTwoSided &&
                        entry[layout::kNameAt + layout::kNameBytes - 1] == 0;
  if (!is_right) return Status::kCorrupted;
  material.shininess = shininess;
  MeshView mesh;
  // Both are within the binary, so they fit std::size_t, which may have 16 bits.
  const std::span<const std::uint8_t> bytes =
      binary.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(size));
  const Status status = view_mesh_binary(bytes, mesh);
  // A mesh that is cut short within a whole file is a fault of the file.
  if (!ok(status)) return status == Status::kTruncated ? Status::kCorrupted : status;
  // Cast by way of void, because signedness of characters does not matter.
  const void* name = entry + layout::kNameAt;
  part = {mesh, material, (flags & layout::kTwoSided) != 0, static_cast<const char*>(name)};
  return Status::kOk;
}

}  // namespace

Status view_model_binary(std::span<const std::uint8_t> bytes, std::span<ModelPart> parts,
                         std::size_t& count) {
  std::size_t found = 0;
  const Status status = read_header(bytes, found);
  if (!ok(status)) return status;
  count = found;
  if (found > parts.size()) return Status::kBufferTooSmall;
  const std::span<const std::uint8_t> binary =
      bytes.first(static_cast<std::size_t>(little_u32(bytes.data() + layout::kSizeAt)));
  for (std::size_t i = 0; i < found; ++i) {
    const std::uint8_t* entry = bytes.data() + layout::kHeaderBytes + i * layout::kPartBytes;
    const Status read = read_part(binary, entry, parts[i]);
    if (!ok(read)) return read;
  }
  return Status::kOk;
}

}  // namespace arcspan
