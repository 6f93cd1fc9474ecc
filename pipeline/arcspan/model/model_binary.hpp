// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/status.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The layout of a model binary (docs/model-binary.md): little-endian, offsets in bytes. A header, an entry
/// for each part, a checksum of both, and a mesh binary for each part. Version 2 has texture binaries, too.
namespace model_binary {
inline constexpr std::uint32_t kMagic = 0x50435241;  ///< "ARCP"
inline constexpr std::uint16_t kVersion = 1;         ///< without textures
inline constexpr std::uint16_t kVersionOfTextures = 2;
// Flags of a part.
inline constexpr std::uint16_t kTwoSided = 1;  ///< back faces are drawn too
inline constexpr std::uint16_t kMasked = 2;    ///< texels whose alpha is 0 are not drawn; version 2 only
inline constexpr std::uint16_t kBlended = 4;   ///< by the alpha of texels; version 2 only

inline constexpr std::size_t kMagicAt = 0;      ///< u32
inline constexpr std::size_t kVersionAt = 4;    ///< u16
inline constexpr std::size_t kPartsAt = 6;      ///< u16
inline constexpr std::size_t kSizeAt = 8;       ///< u32, bytes of the whole binary
inline constexpr std::size_t kVerticesAt = 12;  ///< u32, of the largest part
inline constexpr std::size_t kUnitAt = 16;      ///< f64, length of an object unit in the model's units
inline constexpr std::size_t kOriginAt = 24;    ///< 3 x f64, the model's point at the object's origin
inline constexpr std::size_t kHeaderBytes = 48;

inline constexpr std::size_t kMeshAt = 0;        ///< u32, where the part's mesh binary begins
inline constexpr std::size_t kMeshBytesAt = 4;   ///< u32, its size
inline constexpr std::size_t kAmbientAt = 8;     ///< 3 x u16, raw Coefficient
inline constexpr std::size_t kDiffuseAt = 14;    ///< 3 x u16
inline constexpr std::size_t kSpecularAt = 20;   ///< 3 x u16
inline constexpr std::size_t kShininessAt = 26;  ///< u16
inline constexpr std::size_t kFlagsAt = 28;      ///< u16
inline constexpr std::size_t kNameAt = 32;       ///< text, filled up with zeros
inline constexpr std::size_t kNameBytes = 32;    ///< the last one is zero
inline constexpr std::size_t kPartBytes = 64;
inline constexpr std::size_t kTextureAt =
    64;  ///< u32, where its texture binary begins; 0: none. Version 2 only
inline constexpr std::size_t kTextureBytesAt = 68;     ///< u32, its size
inline constexpr std::size_t kTexturedPartBytes = 72;  ///< of an entry in version 2
inline constexpr std::size_t kChecksumBytes = 4;       ///< u32, crc32() of the header and the entries
}  // namespace model_binary

/// How the alpha of a part's texture is meant.
enum class PartAlpha : std::uint8_t {
  kOpaque,  ///< not at all
  kMasked,  ///< texels whose alpha is 0 are not drawn
  kBlended  ///< it is the opacity
};

/// A part of a model: a mesh with its material. All parts of a model have the same unit and origin.
struct ModelPart {
  MeshView mesh;
  Material material;
  bool two_sided = false;
  const char* name = "";    ///< within the binary
  StoredTexture texture{};  ///< its texels are empty if there is none; see view_texture()
  PartAlpha alpha = PartAlpha::kOpaque;
};

/// Makes views of the parts of a model binary that `arcspan mesh -o NAME.bin` has written. Nothing is copied,
/// so `bytes` must outlive the views. `bytes` may be longer than the binary. All of it is checked once, in
/// time linear in its size. Returns:
///
///   kOk                `count` is the number of parts, which are in parts[0...count)
///   kInvalidArgument   `bytes` does not begin at an even address
///   kUnsupported       the magic number or a version is another, or this machine is big-endian
///   kTruncated         there are fewer bytes than a header has, or than the header states
///   kCorrupted         a checksum is wrong, or counts, sizes, materials and flags contradict each other
///   kIndexOutOfRange   the checksums are right, but an index names no vertex
///   kBufferTooSmall    there are more parts than `parts` has room for; `count` is their number
///
/// After any other status than kOk, `parts` may have been written to.
[[nodiscard]] Status view_model_binary(std::span<const std::uint8_t> bytes, std::span<ModelPart> parts,
                                       std::size_t& count);

}  // namespace arcspan
