// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The layout of a mesh binary (docs/mesh-binary.md): little-endian, offsets in bytes. Version 2 is version 1
/// with optional planes, version 3 is version 2 with optional texture points, version 4 is version 3 with
/// optional colours.
namespace mesh_binary {
inline constexpr std::uint32_t kMagic = 0x4D435241;  ///< "ARCM"
inline constexpr std::uint16_t kVersion = 1;         ///< without planes
inline constexpr std::uint16_t kVersionOfPlanes = 2;
inline constexpr std::uint16_t kVersionOfTexturePoints = 3;
inline constexpr std::uint16_t kVersionOfColours = 4;
inline constexpr std::uint16_t kIndices8 = 1;       ///< flag: indices have 8 bits instead of 16
inline constexpr std::uint16_t kPlanes = 2;         ///< flag: has planes; from version 2 on
inline constexpr std::uint16_t kTexturePoints = 4;  ///< flag: has texture points; from version 3 on
inline constexpr std::uint16_t kColours = 8;        ///< flag: has colours; from version 4 on

inline constexpr std::size_t kMagicAt = 0;       ///< u32
inline constexpr std::size_t kVersionAt = 4;     ///< u16
inline constexpr std::size_t kFlagsAt = 6;       ///< u16
inline constexpr std::size_t kSizeAt = 8;        ///< u32, bytes of the whole binary
inline constexpr std::size_t kVerticesAt = 12;   ///< u32
inline constexpr std::size_t kTrianglesAt = 16;  ///< u32
inline constexpr std::size_t kLowAt = 20;        ///< 3 x i16, MeshBounds::low
inline constexpr std::size_t kHighAt = 26;       ///< 3 x i16, MeshBounds::high
inline constexpr std::size_t kHeaderBytes = 32;
inline constexpr std::size_t kScaleBytes = 4;         ///< PlaneScale: i8, u8, u16
inline constexpr std::size_t kTextureScaleBytes = 4;  ///< TextureScale: u8, and three zeros
inline constexpr std::size_t kChecksumBytes = 4;      ///< u32, crc32() of all bytes before it

/// Size of a whole binary in bytes. It fits 32 bits for at most 65,536 vertices and 2^26 triangles.
template <class Count>
[[nodiscard]] constexpr Count bytes(Count vertices, Count triangles, bool indices8, bool planes = false,
                                    bool texture_points = false, bool colours = false) {
  constexpr auto kAround = static_cast<Count>(kHeaderBytes + kChecksumBytes);
  const Count arrays = 10 * vertices + triangles * (indices8 ? 3 : 6);
  const Count of_planes = planes ? static_cast<Count>(kScaleBytes) + 4 * triangles : 0;
  const Count of_points = texture_points ? static_cast<Count>(kTextureScaleBytes) + 4 * vertices : 0;
  const Count of_colours = colours ? (3 * vertices + 3) & ~Count{3} : 0;
  return ((arrays + 3) & ~Count{3}) + of_planes + of_points + of_colours + kAround;
}
}  // namespace mesh_binary

/// The axis-aligned box around a mesh, in object units.
struct MeshBounds {
  ObjectPosition low;   ///< least x, y and z
  ObjectPosition high;  ///< greatest x, y and z
};

/// Makes a view of the mesh in a binary that `arcspan mesh -o NAME.bin` has written. Nothing is copied, so
/// `bytes` must outlive the view. `bytes` may be longer than the binary, as a flash partition is. The whole
/// binary is checked once, in time linear in its size, except that `bounds` are as it states them. Returns:
///
///   kOk                `view` and, unless it is null, `bounds` are set; otherwise they are not changed
///   kInvalidArgument   `bytes` does not begin at an even address
///   kUnsupported       the magic number or the version is another, or this machine is big-endian
///   kTruncated         there are fewer bytes than a header has, or than the header states
///   kCorrupted         the checksum is wrong, or counts, size, flags, planes and texture points contradict
///                      each other
///   kIndexOutOfRange   the checksum is right, but an index names no vertex
Status view_mesh_binary(std::span<const std::uint8_t> bytes, MeshView& view, MeshBounds* bounds = nullptr);

}  // namespace arcspan
