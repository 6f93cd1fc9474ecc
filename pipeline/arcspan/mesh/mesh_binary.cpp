// SPDX-License-Identifier: MIT
#include <arcspan/mesh/crc32.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>

#include <bit>

namespace arcspan {

namespace {

using namespace mesh_binary;

// The arrays of the binary are read in place.
static_assert(sizeof(ObjectPosition) == 6 && alignof(ObjectPosition) <= 2);
static_assert(sizeof(PackedNormal) == 4 && alignof(PackedNormal) <= 2);
static_assert(sizeof(FacePlane) == 4 && alignof(FacePlane) == 1);
static_assert(sizeof(TexturePoint) == 4 && alignof(TexturePoint) <= 2);
static_assert(sizeof(Rgb8) == 3 && alignof(Rgb8) == 1);

constexpr std::uint32_t kMostTriangles = std::uint32_t{1} << 26;

ObjectPosition position_at(const std::uint8_t* bytes, std::size_t at) {
  return {static_cast<std::int16_t>(little_u16(bytes + at)),
          static_cast<std::int16_t>(little_u16(bytes + at + 2)),
          static_cast<std::int16_t>(little_u16(bytes + at + 4))};
}

struct Header {
  std::uint32_t size;
  std::uint32_t vertices;
  std::uint32_t triangles;
  bool indices8;
  bool planes;
  bool texture_points;
  bool colours;
};

/// Reads and checks all of a binary except the contents of its arrays.
Status read_header(std::span<const std::uint8_t> bytes, Header& header) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= kVersionAt && little_u32(at + kMagicAt) != kMagic) return Status::kUnsupported;
  if (bytes.size() < kHeaderBytes + kChecksumBytes) return Status::kTruncated;
  const std::uint16_t version = little_u16(at + kVersionAt);
  if (version < kVersion || version > kVersionOfColours) return Status::kUnsupported;
  const std::uint16_t flags = little_u16(at + kFlagsAt);
  header = {little_u32(at + kSizeAt), little_u32(at + kVerticesAt), little_u32(at + kTrianglesAt),
            (flags & kIndices8) != 0, (flags & kPlanes) != 0,       (flags & kTexturePoints) != 0,
            (flags & kColours) != 0};
  // Each version has one flag more.
  if (flags >= (1u << version) || header.vertices > MeshView::kMaxVertices ||
      header.triangles > kMostTriangles ||
      header.size != mesh_binary::bytes(header.vertices, header.triangles, header.indices8, header.planes,
                                        header.texture_points, header.colours)) {
    return Status::kCorrupted;
  }
  if (bytes.size() < header.size) return Status::kTruncated;
  const std::size_t covered = static_cast<std::size_t>(header.size) - kChecksumBytes;
  return crc32(bytes.first(covered)) == little_u32(at + covered) ? Status::kOk : Status::kCorrupted;
}

/// Attaches the planes of a checked binary, which begin at offset `at`, if it has any, and moves `at` to
/// their end.
Status attach_planes(std::span<const std::uint8_t> bytes, const Header& header, std::size_t& at,
                     MeshView& view) {
  if (!header.planes) return Status::kOk;
  const auto triangles = static_cast<std::size_t>(header.triangles);
  const std::uint8_t* const scale = bytes.data() + at;
  const void* const planes = scale + kScaleBytes;
  at += kScaleBytes + sizeof(FacePlane) * triangles;
  const Status status = view.attach(std::span(static_cast<const FacePlane*>(planes), triangles),
                                    {static_cast<std::int8_t>(scale[0]), scale[1], little_u16(scale + 2)});
  return ok(status) ? status : Status::kCorrupted;
}

/// Attaches the texture points at offset `at`, if there are any, and moves `at` to their end.
Status attach_texture_points(std::span<const std::uint8_t> bytes, const Header& header, std::size_t& at,
                             MeshView& view) {
  if (!header.texture_points) return Status::kOk;
  const std::uint8_t* const scale = bytes.data() + at;
  const void* const points = scale + kTextureScaleBytes;
  at += kTextureScaleBytes + sizeof(TexturePoint) * static_cast<std::size_t>(header.vertices);
  if (little_u32(scale) > 0xFF) return Status::kCorrupted;
  const Status status = view.attach(
      std::span(static_cast<const TexturePoint*>(points), static_cast<std::size_t>(header.vertices)),
      {scale[0]});
  return ok(status) ? status : Status::kCorrupted;
}

}  // namespace

Status view_mesh_binary(std::span<const std::uint8_t> bytes, MeshView& view, MeshBounds* bounds) {
  Header header{};
  const Status status = read_header(bytes, header);
  if (!ok(status)) return status;
  // Cast by way of void, because alignment has been checked.
  const auto array_at = [&bytes](std::size_t at) -> const void* { return bytes.data() + at; };
  // Sizes fit std::size_t, because the whole binary is in memory.
  const auto vertices = static_cast<std::size_t>(header.vertices);
  const std::size_t normals_at = kHeaderBytes + 6 * vertices;
  const std::size_t indices_at = normals_at + 4 * vertices;
  const std::span positions(static_cast<const ObjectPosition*>(array_at(kHeaderBytes)), vertices);
  const std::span normals(static_cast<const PackedNormal*>(array_at(normals_at)), vertices);
  const std::size_t indices = 3 * static_cast<std::size_t>(header.triangles);
  MeshView found;
  Status made = header.indices8
                    ? MeshView::make(positions, normals, bytes.subspan(indices_at, indices), found)
                    : MeshView::make(
                          positions, normals,
                          std::span(static_cast<const std::uint16_t*>(array_at(indices_at)), indices), found);
  const auto index_bytes = static_cast<std::size_t>(header.indices8 ? indices : 2 * indices);
  std::size_t at = indices_at + index_bytes;
  at += (0 - (at - kHeaderBytes)) & 3u;
  if (ok(made)) made = attach_planes(bytes, header, at, found);
  if (ok(made)) made = attach_texture_points(bytes, header, at, found);
  if (ok(made) && header.colours) {
    made = found.attach(std::span(static_cast<const Rgb8*>(array_at(at)), vertices));
  }
  if (!ok(made)) return made;
  view = found;
  if (bounds != nullptr) {
    *bounds = {position_at(bytes.data(), kLowAt), position_at(bytes.data(), kHighAt)};
  }
  return Status::kOk;
}

}  // namespace arcspan
