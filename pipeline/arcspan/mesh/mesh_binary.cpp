// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>

#include <bit>

namespace arcspan {

namespace {

using namespace mesh_binary;

// The arrays are used as they lie in the binary.
static_assert(sizeof(ObjectPosition) == 6 && alignof(ObjectPosition) <= 2);
static_assert(sizeof(PackedNormal) == 4 && alignof(PackedNormal) <= 2);

constexpr std::uint32_t kMostTriangles = std::uint32_t{1} << 26;

std::uint16_t u16_at(const std::uint8_t* bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
}

std::uint32_t u32_at(const std::uint8_t* bytes, std::size_t at) {
  return u16_at(bytes, at) | (std::uint32_t{u16_at(bytes, at + 2)} << 16);
}

ObjectPosition position_at(const std::uint8_t* bytes, std::size_t at) {
  return {static_cast<std::int16_t>(u16_at(bytes, at)), static_cast<std::int16_t>(u16_at(bytes, at + 2)),
          static_cast<std::int16_t>(u16_at(bytes, at + 4))};
}

struct Header {
  std::uint32_t size;
  std::uint32_t vertices;
  std::uint32_t triangles;
  bool indices8;
};

/// Everything that can be wrong but the arrays themselves.
Status read_header(std::span<const std::uint8_t> bytes, Header& header) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= kVersionAt && u32_at(at, kMagicAt) != kMagic) return Status::kUnsupported;
  if (bytes.size() < kHeaderBytes + kChecksumBytes) return Status::kTruncated;
  if (u16_at(at, kVersionAt) != kVersion) return Status::kUnsupported;
  const std::uint16_t flags = u16_at(at, kFlagsAt);
  header = {u32_at(at, kSizeAt), u32_at(at, kVerticesAt), u32_at(at, kTrianglesAt), flags == kIndices8};
  if (flags > kIndices8 || header.vertices > MeshView::kMaxVertices || header.triangles > kMostTriangles ||
      header.size != mesh_binary::bytes(header.vertices, header.triangles, header.indices8)) {
    return Status::kCorrupted;
  }
  if (bytes.size() < header.size) return Status::kTruncated;
  const std::size_t covered = static_cast<std::size_t>(header.size) - kChecksumBytes;
  return crc32(bytes.first(covered)) == u32_at(at, covered) ? Status::kOk : Status::kCorrupted;
}

}  // namespace

Status view_mesh_binary(std::span<const std::uint8_t> bytes, MeshView& view, MeshBounds* bounds) {
  Header header{};
  const Status status = read_header(bytes, header);
  if (!ok(status)) return status;
  // The cast's detour over void says that alignment was seen to.
  const auto array_at = [&bytes](std::size_t at) -> const void* { return bytes.data() + at; };
  // All of it lies in memory, so its parts can be counted.
  const auto vertices = static_cast<std::size_t>(header.vertices);
  const std::size_t normals_at = kHeaderBytes + 6 * vertices;
  const std::size_t indices_at = normals_at + 4 * vertices;
  const std::span positions(static_cast<const ObjectPosition*>(array_at(kHeaderBytes)), vertices);
  const std::span normals(static_cast<const PackedNormal*>(array_at(normals_at)), vertices);
  const std::size_t indices = 3 * static_cast<std::size_t>(header.triangles);
  const Status made =
      header.indices8
          ? MeshView::make(positions, normals, bytes.subspan(indices_at, indices), view)
          : MeshView::make(positions, normals,
                           std::span(static_cast<const std::uint16_t*>(array_at(indices_at)), indices), view);
  if (ok(made) && bounds != nullptr) {
    *bounds = {position_at(bytes.data(), kLowAt), position_at(bytes.data(), kHighAt)};
  }
  return made;
}

}  // namespace arcspan
