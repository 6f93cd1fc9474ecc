// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

/// How mesh binaries are read, by themselves and as chunks of a model binary. Everything is inlined into the
/// few functions that read, so that a program has only what it reads.
namespace arcspan::detail {

// The arrays of the binary are read in place.
static_assert(sizeof(ObjectPosition) == 6 && alignof(ObjectPosition) <= 2);
static_assert(sizeof(PackedNormal) == 4 && alignof(PackedNormal) <= 2);
static_assert(sizeof(FacePlane) == 4 && alignof(FacePlane) == 1);
static_assert(sizeof(TexturePoint) == 4 && alignof(TexturePoint) <= 2);
static_assert(sizeof(Rgb8) == 3 && alignof(Rgb8) == 1);

inline constexpr std::uint32_t kMostTriangles = std::uint32_t{1} << 26;

/// The header of a mesh binary: sizes and the arrays that follow.
struct MeshHeader {
  std::uint32_t size;
  std::uint32_t vertices;
  std::uint32_t triangles;
  bool indices8;
  bool planes;
  bool texture_points;
  bool colours;
};

/// Reads what a header says.
[[nodiscard]] ARCSPAN_INLINE inline MeshHeader mesh_header_at(const std::uint8_t* at) {
  const std::uint16_t flags = little_u16(at + mesh_binary::kFlagsAt);
  return {little_u32(at + mesh_binary::kSizeAt),      little_u32(at + mesh_binary::kVerticesAt),
          little_u32(at + mesh_binary::kTrianglesAt), (flags & mesh_binary::kIndices8) != 0,
          (flags & mesh_binary::kPlanes) != 0,        (flags & mesh_binary::kTexturePoints) != 0,
          (flags & mesh_binary::kColours) != 0};
}

/// Reads and checks the header of a mesh that ends with `checksum` bytes.
[[nodiscard]] ARCSPAN_INLINE inline Status read_mesh_header(std::span<const std::uint8_t> bytes,
                                                            std::uint32_t checksum, MeshHeader& header) {
  if (std::endian::native != std::endian::little) return Status::kUnsupported;
  const std::uint8_t* at = bytes.data();
  if ((reinterpret_cast<std::uintptr_t>(at) & 1u) != 0) return Status::kInvalidArgument;
  if (bytes.size() >= mesh_binary::kVersionAt &&
      little_u32(at + mesh_binary::kMagicAt) != mesh_binary::kMagic)
    return Status::kUnsupported;
  if (bytes.size() < mesh_binary::kHeaderBytes + checksum) return Status::kTruncated;
  const std::uint16_t version = little_u16(at + mesh_binary::kVersionAt);
  if (version < mesh_binary::kVersion || version > mesh_binary::kVersionOfColours)
    return Status::kUnsupported;
  header = mesh_header_at(at);
  // Each version has one flag more.
  if (little_u16(at + mesh_binary::kFlagsAt) >= (1u << version) || header.vertices > MeshView::kMaxVertices ||
      header.triangles > kMostTriangles ||
      header.size - checksum != mesh_binary::bytes(header.vertices, header.triangles, header.indices8,
                                                   header.planes, header.texture_points, header.colours) -
                                    std::uint32_t{mesh_binary::kChecksumBytes}) {
    return Status::kCorrupted;
  }
  return bytes.size() < header.size ? Status::kTruncated : Status::kOk;
}

/// The arrays of a mesh, where they lie in its binary.
struct MeshArrays {
  std::size_t vertices;
  std::size_t triangles;
  const ObjectPosition* positions;
  const PackedNormal* normals;
  const std::uint8_t* indices8 = nullptr;  ///< one of both is null
  const std::uint16_t* indices16 = nullptr;
  const std::uint8_t* plane_scale = nullptr;  ///< null without planes
  const FacePlane* planes = nullptr;
  const std::uint8_t* texture_scale = nullptr;  ///< null without texture points
  const TexturePoint* texture_points = nullptr;
  const Rgb8* colours = nullptr;  ///< null without colours

  // Sizes fit std::size_t, because the whole binary is in memory.
  ARCSPAN_INLINE MeshArrays(const MeshHeader& header, const std::uint8_t* binary)
      : vertices(static_cast<std::size_t>(header.vertices)),
        triangles(static_cast<std::size_t>(header.triangles)) {
    const std::uint8_t* const first_normal = binary + mesh_binary::kHeaderBytes + 6 * vertices;
    const std::uint8_t* const first_index = first_normal + 4 * vertices;
    positions = elements_at<ObjectPosition>(binary + mesh_binary::kHeaderBytes);
    normals = elements_at<PackedNormal>(first_normal);
    const std::size_t index_bytes = (header.indices8 ? 3 : 6) * triangles;
    if (header.indices8) {
      indices8 = first_index;
    } else {
      indices16 = elements_at<std::uint16_t>(first_index);
    }
    const std::uint8_t* at = first_index + index_bytes + ((0 - (10 * vertices + index_bytes)) & 3u);
    if (header.planes) {
      plane_scale = at;
      planes = elements_at<FacePlane>(at + mesh_binary::kScaleBytes);
      at += mesh_binary::kScaleBytes + sizeof(FacePlane) * triangles;
    }
    if (header.texture_points) {
      texture_scale = at;
      texture_points = elements_at<TexturePoint>(at + mesh_binary::kTextureScaleBytes);
      at += mesh_binary::kTextureScaleBytes + sizeof(TexturePoint) * vertices;
    }
    if (header.colours) colours = elements_at<Rgb8>(at);
  }

  [[nodiscard]] PlaneScale scale_of_planes() const {
    return {static_cast<std::int8_t>(plane_scale[0]), plane_scale[1], little_u16(plane_scale + 2)};
  }
  /// A view of arrays that check() has accepted.
  [[nodiscard]] ARCSPAN_INLINE MeshView checked_view() const {
    MeshView view({positions, vertices}, {normals, vertices}, triangles);
    view.indices8_ = indices8;
    view.indices16_ = indices16;
    view.planes_ = planes;
    if (planes != nullptr) view.plane_scale_ = scale_of_planes();
    view.texture_points_ = texture_points;
    if (texture_points != nullptr) view.texture_scale_ = {texture_scale[0]};
    view.colours_ = colours;
    return view;
  }
  /// Makes a view, after all checks of MeshView.
  [[nodiscard]] ARCSPAN_INLINE Status check(MeshView& view) const {
    const std::span vertex_positions(positions, vertices);
    const std::span vertex_normals(normals, vertices);
    const Status status =
        indices8 != nullptr
            ? MeshView::make(vertex_positions, vertex_normals, std::span(indices8, 3 * triangles), view)
            : MeshView::make(vertex_positions, vertex_normals, std::span(indices16, 3 * triangles), view);
    return ok(status) ? check_attached(view) : status;
  }
  /// Attaches what is there besides vertices and triangles.
  [[nodiscard]] ARCSPAN_INLINE Status check_attached(MeshView& view) const {
    Status status = Status::kOk;
    if (planes != nullptr) status = view.attach(std::span(planes, triangles), scale_of_planes());
    if (ok(status) && texture_points != nullptr) {
      if (little_u32(texture_scale) > 0xFF) return Status::kCorrupted;
      status = view.attach(std::span(texture_points, vertices), {texture_scale[0]});
    }
    if (ok(status) && colours != nullptr) status = view.attach(std::span(colours, vertices));
    return ok(status) ? status : Status::kCorrupted;
  }
};

}  // namespace arcspan::detail
