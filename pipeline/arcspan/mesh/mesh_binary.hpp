// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The layout of a mesh binary (docs/mesh-binary.md): little-endian, offsets in bytes. Version 2 has what
/// version 1 has, and may have planes.
namespace mesh_binary {
inline constexpr std::uint32_t kMagic = 0x4D435241;  ///< "ARCM"
inline constexpr std::uint16_t kVersion = 1;
inline constexpr std::uint16_t kVersionOfPlanes = 2;
inline constexpr std::uint16_t kIndices8 = 1;  ///< flag: indices have 8 bits instead of 16
inline constexpr std::uint16_t kPlanes = 2;    ///< flag: there are planes; version 2 only

inline constexpr std::size_t kMagicAt = 0;       ///< u32
inline constexpr std::size_t kVersionAt = 4;     ///< u16
inline constexpr std::size_t kFlagsAt = 6;       ///< u16
inline constexpr std::size_t kSizeAt = 8;        ///< u32, all bytes from magic to checksum
inline constexpr std::size_t kVerticesAt = 12;   ///< u32
inline constexpr std::size_t kTrianglesAt = 16;  ///< u32
inline constexpr std::size_t kLowAt = 20;        ///< 3 x i16, the least x, y, z
inline constexpr std::size_t kHighAt = 26;       ///< 3 x i16, the greatest
inline constexpr std::size_t kHeaderBytes = 32;
inline constexpr std::size_t kScaleBytes = 4;     ///< PlaneScale: i8, u8, u16
inline constexpr std::size_t kChecksumBytes = 4;  ///< u32, crc32() of all before it

/// Bytes of a whole binary; at most 65,536 vertices and 2^26 triangles, so that it fits 32 bits.
template <class Count>
[[nodiscard]] constexpr Count bytes(Count vertices, Count triangles, bool indices8, bool planes = false) {
  constexpr auto kAround = static_cast<Count>(kHeaderBytes + kChecksumBytes);
  const Count arrays = 10 * vertices + triangles * (indices8 ? 3 : 6);
  const Count of_planes = planes ? static_cast<Count>(kScaleBytes) + 4 * triangles : 0;
  return ((arrays + 3) & ~Count{3}) + of_planes + kAround;
}
}  // namespace mesh_binary

/// The corners of the box around a mesh, in object units.
struct MeshBounds {
  ObjectPosition low;
  ObjectPosition high;
};

/// A mesh from the binary that `arcspan mesh -o NAME.bin` writes, used where it lies: nothing is copied, so
/// `bytes` must stay. It may be longer than the binary (a flash partition). Everything is checked, once and
/// in time linear in its size, before a single vertex is used:
///
///   kInvalidArgument   `bytes` does not begin at an even address
///   kUnsupported       foreign: another magic number or version; or this machine is big-endian
///   kTruncated         fewer bytes than a header, or than the header says
///   kCorrupted         the checksum is wrong, or counts, size and flags do not agree
///   kIndexOutOfRange   the checksum is right, yet an index names no vertex
///
/// `view` and `bounds` (which may be null) are untouched unless kOk.
Status view_mesh_binary(std::span<const std::uint8_t> bytes, MeshView& view, MeshBounds* bounds = nullptr);

}  // namespace arcspan
