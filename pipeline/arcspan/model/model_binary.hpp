// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/model/chunk_list.hpp>
#include <arcspan/status.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The chunks of a model binary (docs/model-binary.md): little-endian, offsets in bytes.
namespace model_binary {
inline constexpr std::uint32_t kModelTag = chunk_tag('M', 'O', 'D', 'L');    ///< number 0
inline constexpr std::uint32_t kPartsTag = chunk_tag('P', 'A', 'R', 'T');    ///< number 0: a record per part
inline constexpr std::uint32_t kMeshTag = chunk_tag('M', 'E', 'S', 'H');     ///< number: the part's
inline constexpr std::uint32_t kTextureTag = chunk_tag('T', 'X', 'T', 'R');  ///< number: counted from 0

// Chunk MODL.
inline constexpr std::size_t kVerticesAt = 0;  ///< u32, of the largest part
inline constexpr std::size_t kSphereAt = 4;    ///< 3 x i16, u16: BoundingSphere of all parts
inline constexpr std::size_t kUnitAt = 12;     ///< f64, length of an object unit in the model's units
inline constexpr std::size_t kOriginAt = 20;   ///< 3 x f64, the model's point at the object's origin
inline constexpr std::size_t kModelBytes = 44;

// A record of chunk PART.
inline constexpr std::size_t kAmbientAt = 0;      ///< 3 x u16, raw Coefficient
inline constexpr std::size_t kDiffuseAt = 6;      ///< 3 x u16
inline constexpr std::size_t kSpecularAt = 12;    ///< 3 x u16
inline constexpr std::size_t kShininessAt = 18;   ///< u16
inline constexpr std::size_t kFlagsAt = 20;       ///< u16
inline constexpr std::size_t kTextureAt = 22;     ///< u16, number of its texture or kNoTexture
inline constexpr std::size_t kPartSphereAt = 24;  ///< 3 x i16, u16: BoundingSphere
inline constexpr std::size_t kNameAt = 32;        ///< text, filled up with zeros
inline constexpr std::size_t kNameBytes = 32;     ///< the last one is zero
inline constexpr std::size_t kPartBytes = 64;
inline constexpr std::uint16_t kNoTexture = 0xFFFF;
// Flags of a part.
inline constexpr std::uint16_t kTwoSided = 1;  ///< back faces are drawn too
inline constexpr std::uint16_t kMasked = 2;    ///< texels whose alpha is below one half are not drawn
inline constexpr std::uint16_t kBlended = 4;   ///< by the alpha of texels
}  // namespace model_binary

/// How the alpha of a part's texture is meant.
enum class PartAlpha : std::uint8_t {
  kOpaque,  ///< not at all
  kMasked,  ///< texels whose alpha is below one half are not drawn
  kBlended  ///< it is the opacity
};

/// A part of a model: a mesh with its material. All parts of a model have the same unit and origin.
struct ModelPart {
  MeshView mesh;  ///< of a model that moves as it is stored, which may be another pose than at rest
  Material material;
  bool two_sided = false;
  const char* name = "";    ///< within the binary
  StoredTexture texture{};  ///< its texels are empty if there is none; see view_texture()
  PartAlpha alpha = PartAlpha::kOpaque;
  BoundingSphere sphere;  ///< as the binary says, for Object
};

/// A model in a binary, made by view_model_binary(). It takes a few words, whatever the number of parts, and
/// can be copied. The binary must outlive it, and the parts that it returns.
class StoredModel {
 public:
  [[nodiscard]] std::size_t part_count() const { return part_count_; }
  /// Part `i`, which must be below part_count(). Nothing is checked again: the time does not depend on the
  /// size of the part, and is logarithmic in the number of chunks.
  [[nodiscard]] ModelPart part(std::size_t i) const;
  /// Vertices of the largest part, which a vertex cache has to hold.
  [[nodiscard]] std::size_t most_vertices() const;
  /// A sphere around all parts, as the binary says.
  [[nodiscard]] BoundingSphere sphere() const;
  /// All chunks, also those that this version of the library does not know.
  [[nodiscard]] const ChunkList& chunks() const { return chunks_; }

 private:
  friend Status view_model_binary(std::span<const std::uint8_t> bytes, StoredModel& model);

  [[nodiscard]] Status find_chunks(std::span<const std::uint8_t> bytes);
  [[nodiscard]] Status check() const;

  ChunkList chunks_;
  const std::uint8_t* head_ = nullptr;   ///< chunk MODL
  const std::uint8_t* parts_ = nullptr;  ///< chunk PART
  std::size_t part_count_ = 0;
};

/// Makes a view of a model binary that `arcspan mesh -o NAME.bin` has written. Nothing is copied. `bytes` may
/// be longer than the binary. All of it is checked once, in time linear in its size. Chunks of unknown tags
/// are allowed and not looked at. Returns:
///
///   kOk                `model` is set; otherwise it is not changed
///   kInvalidArgument   `bytes` does not begin at a multiple of 4
///   kUnsupported       the magic number or a version is another, or this machine is big-endian
///   kTruncated         there are fewer bytes than a header has, or than the header states
///   kCorrupted         the checksum is wrong, a chunk is missing or lies outside of the binary, or counts,
///                      sizes, materials and flags contradict each other
///   kIndexOutOfRange   the checksum is right, but an index names no vertex
///
/// Bounding spheres and boxes are not checked; with a wrong sphere an object in view may be left out.
[[nodiscard]] Status view_model_binary(std::span<const std::uint8_t> bytes, StoredModel& model);

}  // namespace arcspan
