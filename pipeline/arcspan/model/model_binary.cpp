// SPDX-License-Identifier: MIT
#include <arcspan/checked.hpp>
#include <arcspan/mesh/mesh_chunk.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/texture/texture_chunk.hpp>

namespace arcspan {

namespace {

using namespace model_binary;

constexpr std::uint16_t kWhole = 1u << Coefficient::kFraction;

ChannelCoefficients channels_at(const std::uint8_t* at) {
  return {Coefficient::from_raw(little_u16(at)), Coefficient::from_raw(little_u16(at + 2)),
          Coefficient::from_raw(little_u16(at + 4))};
}

BoundingSphere sphere_at(const std::uint8_t* at) {
  return {{static_cast<std::int16_t>(little_u16(at)), static_cast<std::int16_t>(little_u16(at + 2)),
           static_cast<std::int16_t>(little_u16(at + 4))},
          little_u16(at + 6)};
}

/// Whether a record of chunk PART makes sense in a model of so many textures.
bool is_valid_part(const std::uint8_t* record, std::uint32_t textures) {
  for (std::size_t at = kAmbientAt; at < kShininessAt; at += 2) {
    if (little_u16(record + at) > kWhole) return false;
  }
  const std::uint16_t shininess = little_u16(record + kShininessAt);
  const std::uint16_t texture = little_u16(record + kTextureAt);
  // No other flags, and one of alpha only.
  return shininess >= 1 && shininess <= 256 && little_u16(record + kFlagsAt) < (kMasked | kBlended) &&
         (texture == kNoTexture || texture < textures) && record[kNameAt + kNameBytes - 1] == 0;
}

/// What the chunks of meshes and textures have in common.
struct ChunkFigures {
  std::uint32_t meshes = 0;
  std::uint32_t textures = 0;
  std::size_t most_vertices = 0;
};

/// Checks a chunk of a known tag, and adds it to `figures`. Chunks come in the order of their numbers.
Status check_chunk(const Chunk& chunk, ChunkFigures& figures) {
  if (chunk.tag == kTextureTag) {
    if (chunk.number != figures.textures++) return Status::kCorrupted;
    return detail::check_texture_chunk(chunk.bytes);
  }
  if (chunk.tag != kMeshTag) return Status::kOk;
  if (chunk.number != figures.meshes++) return Status::kCorrupted;
  const Status status = detail::check_mesh_chunk(chunk.bytes);
  if (!ok(status)) return status;
  const std::size_t vertices = detail::mesh_of_chunk(chunk.bytes.data()).vertex_count();
  if (vertices > figures.most_vertices) figures.most_vertices = vertices;
  return Status::kOk;
}

}  // namespace

std::size_t StoredModel::most_vertices() const {
  return head_ == nullptr ? 0 : static_cast<std::size_t>(little_u32(head_ + kVerticesAt));
}

BoundingSphere StoredModel::sphere() const {
  return head_ == nullptr ? BoundingSphere{} : sphere_at(head_ + kSphereAt);
}

ModelPart StoredModel::part(std::size_t i) const {
  ARCSPAN_CHECK(i < part_count_, "StoredModel::part: the model has no such part");
  const std::uint8_t* const record = parts_ + i * kPartBytes;
  const std::uint16_t flags = little_u16(record + kFlagsAt);
  const std::uint16_t texture = little_u16(record + kTextureAt);
  const void* const name = record + kNameAt;  // signedness of characters does not matter
  ModelPart part;
  part.mesh = detail::mesh_of_chunk(chunks_.find(kMeshTag, static_cast<std::uint32_t>(i)).data());
  part.material = {channels_at(record + kAmbientAt), channels_at(record + kDiffuseAt),
                   channels_at(record + kSpecularAt), little_u16(record + kShininessAt)};
  part.two_sided = (flags & kTwoSided) != 0;
  part.name = static_cast<const char*>(name);
  if (texture != kNoTexture)
    part.texture = detail::texture_of_chunk(chunks_.find(kTextureTag, texture).data());
  if ((flags & kMasked) != 0) part.alpha = PartAlpha::kMasked;
  if ((flags & kBlended) != 0) part.alpha = PartAlpha::kBlended;
  part.sphere = sphere_at(record + kPartSphereAt);
  return part;
}

/// Sets the members, of a list of chunks that is valid.
Status StoredModel::find_chunks(std::span<const std::uint8_t> bytes) {
  const Status status = view_chunk_list(bytes, chunks_);
  if (!ok(status)) return status;
  const std::span<const std::uint8_t> head = chunks_.find(kModelTag);
  const std::span<const std::uint8_t> parts = chunks_.find(kPartsTag);
  if (head.size() != kModelBytes || parts.data() == nullptr || parts.size() % kPartBytes != 0)
    return Status::kCorrupted;
  head_ = head.data();
  parts_ = parts.data();
  part_count_ = parts.size() / kPartBytes;
  return Status::kOk;
}

/// Checks what is in the chunks, each once.
Status StoredModel::check() const {
  ChunkFigures figures;
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const Status status = check_chunk(chunks_[i], figures);
    if (!ok(status)) return status;
  }
  if (figures.meshes != part_count_ || figures.most_vertices != little_u32(head_ + kVerticesAt))
    return Status::kCorrupted;
  for (std::size_t i = 0; i < part_count_; ++i) {
    if (!is_valid_part(parts_ + i * kPartBytes, figures.textures)) return Status::kCorrupted;
  }
  return Status::kOk;
}

Status view_model_binary(std::span<const std::uint8_t> bytes, StoredModel& model) {
  StoredModel found;
  Status status = found.find_chunks(bytes);
  if (ok(status)) status = found.check();
  if (ok(status)) model = found;
  return status;
}

}  // namespace arcspan
