// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/model/chunk_list.hpp>
#include <arcspan/numbers/fixed_formats.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The chunks of a model binary that hold animation (docs/animation-binary.md), and their limits. Records are
/// read in place as the structures below.
namespace animation_binary {
inline constexpr std::uint32_t kNodesTag = chunk_tag('N', 'O', 'D', 'E');    ///< number 0
inline constexpr std::uint32_t kNamesTag = chunk_tag('N', 'N', 'A', 'M');    ///< number 0
inline constexpr std::uint32_t kSkinTag = chunk_tag('S', 'K', 'I', 'N');     ///< number: counted from 0
inline constexpr std::uint32_t kWeightsTag = chunk_tag('W', 'G', 'H', 'T');  ///< number: the part's
inline constexpr std::uint32_t kMorphTag = chunk_tag('M', 'R', 'P', 'H');    ///< number: the part's
inline constexpr std::uint32_t kBoundsTag = chunk_tag('B', 'N', 'D', 'S');   ///< number: the part's
inline constexpr std::uint32_t kClipTag = chunk_tag('C', 'L', 'I', 'P');     ///< number: counted from 0

inline constexpr std::size_t kCountBytes = 4;  ///< of NODE, SKIN and BNDS: u16 count, u16 zero

inline constexpr std::size_t kMostNodes = 4096;
inline constexpr std::size_t kMostJoints = 256;   ///< of a skin
inline constexpr std::size_t kMostTargets = 256;  ///< of a part
inline constexpr std::size_t kNameBytes = 32;     ///< the last one is zero
inline constexpr std::uint16_t kNoParent = 0xFFFF;

// Chunk WGHT.
inline constexpr std::size_t kSkinAt = 0;      ///< u16
inline constexpr std::size_t kJointAt = 2;     ///< u16
inline constexpr std::size_t kVerticesAt = 4;  ///< u32, 0 if the mesh follows one joint
inline constexpr std::size_t kWordsAt = 8;     ///< u32, half-words of the records
inline constexpr std::size_t kFirstAt = 12;    ///< u16 for each vertex
inline constexpr std::uint32_t kMostWords = 65536;

// Chunk MRPH.
inline constexpr std::size_t kTargetsAt = 0;         ///< u16
inline constexpr std::size_t kFlagsAt = 2;           ///< u16
inline constexpr std::size_t kMorphVerticesAt = 4;   ///< u32
inline constexpr std::size_t kRecordsAt = 8;         ///< u32
inline constexpr std::size_t kMorphWeightsAt = 12;   ///< i16 for each target
inline constexpr std::uint16_t kMorphedNormals = 1;  ///< flag
inline constexpr std::size_t kShortRecordBytes = 8;  ///< of a record without a normal
inline constexpr std::uint32_t kMostRecords = 65535;

// Chunk CLIP.
inline constexpr std::size_t kDurationAt = 0;  ///< u32, microseconds
inline constexpr std::size_t kChannelsAt = 4;  ///< u16, and a u16 that is zero
inline constexpr std::size_t kNameAt = 8;
inline constexpr std::size_t kClipBytes = kNameAt + kNameBytes;  ///< before the channels

inline constexpr std::uint32_t kLongestTime = std::uint32_t{1} << 30;        ///< microseconds
inline constexpr std::int32_t kLongestLength = (std::int32_t{1} << 30) - 1;  ///< raw ObjectLength
inline constexpr std::int32_t kLargestScale = std::int32_t{64} << 16;        ///< raw WorldLength
inline constexpr int kTangentBits = 13;      ///< fraction bits of a tangent of rotations
inline constexpr int kMorphWeightBits = 12;  ///< fraction bits of a morph weight
inline constexpr int kMorphNormalBits = 14;  ///< fraction bits of a morphed normal
inline constexpr int kMatrixBits = 24;       ///< fraction bits of an entry of a matrix
inline constexpr int kWeightBits = 10;       ///< fraction bits of the weight of a joint
}  // namespace animation_binary

/// A translation, in object units.
struct StoredTranslation {
  ObjectLength x;
  ObjectLength y;
  ObjectLength z;
};

/// A rotation as a quaternion, in 32767ths; a tangent of one has 13 fraction bits.
struct StoredRotation {
  std::int16_t x;
  std::int16_t y;
  std::int16_t z;
  std::int16_t w;
};

/// A factor for each axis, 16 fraction bits.
struct StoredScale {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

/// A node at rest, relative to its parent.
struct StoredNode {
  std::uint16_t parent;  ///< a lower number, or animation_binary::kNoParent
  std::uint16_t zero;
  StoredTranslation translation;
  StoredRotation rotation;
  StoredScale scale;
};

/// A row of a matrix: entries with 24 fraction bits, and what is added.
struct StoredMatrixRow {
  std::int32_t entries[3];
  ObjectLength offset;
};

/// A joint of a skin. The matrix leads from the space of the meshes to that of the node (the inverse bind
/// matrix).
struct StoredJoint {
  std::uint16_t node;
  std::uint16_t zero;
  StoredMatrixRow rows[3];
};

/// A sphere around the vertices of a mesh that follow a joint, as they lie in the mesh.
struct JointBound {
  std::uint16_t joint;
  std::uint16_t zero;
  BoundingSphere sphere;
};

/// The change of a vertex's position by a morph target at weight 1. In chunks with normals four half-words
/// follow.
struct MorphRecord {
  std::uint16_t target;
  ObjectPosition position;
};

/// The property of a node or part that a channel changes.
enum class ChannelPath : std::uint8_t { kTranslation, kRotation, kScale, kMorphWeights };

/// How a channel leads from one key to the next.
enum class Interpolation : std::uint8_t { kStep, kLinear, kCubic };

/// A channel of a clip. Offsets are in bytes from the beginning of the chunk.
struct StoredChannel {
  std::uint16_t target;  ///< node, or part for morph weights
  ChannelPath path;
  Interpolation interpolation;
  std::uint32_t times;
  std::uint32_t values;
  std::uint16_t keys;
  std::uint16_t zero;
};

static_assert(sizeof(StoredTranslation) == 12 && sizeof(StoredRotation) == 8 && sizeof(StoredScale) == 12);
static_assert(sizeof(StoredNode) == 36 && alignof(StoredNode) <= chunk_list::kAlignment);
static_assert(sizeof(StoredJoint) == 52 && alignof(StoredJoint) <= chunk_list::kAlignment);
static_assert(sizeof(JointBound) == 12 && alignof(JointBound) <= chunk_list::kAlignment);
static_assert(sizeof(MorphRecord) == 8 && alignof(MorphRecord) <= 2);
static_assert(sizeof(StoredChannel) == 16 && alignof(StoredChannel) <= chunk_list::kAlignment);

}  // namespace arcspan
