// SPDX-License-Identifier: MIT
#include <arcspan/checked.hpp>
#include <arcspan/mesh/mesh_chunk.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan/numbers/little_endian.hpp>
#include <arcspan/texture/texture_chunk.hpp>

namespace arcspan {

namespace {

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
  for (std::size_t at = model_binary::kAmbientAt; at < model_binary::kShininessAt; at += 2) {
    if (little_u16(record + at) > kWhole) return false;
  }
  const std::uint16_t shininess = little_u16(record + model_binary::kShininessAt);
  const std::uint16_t texture = little_u16(record + model_binary::kTextureAt);
  // No other flags, and one of alpha only.
  return shininess >= 1 && shininess <= 256 &&
         little_u16(record + model_binary::kFlagsAt) < (model_binary::kMasked | model_binary::kBlended) &&
         (texture == model_binary::kNoTexture || texture < textures) &&
         record[model_binary::kNameAt + model_binary::kNameBytes - 1] == 0;
}

/// Counts of the chunks that have been checked.
struct ChunkFigures {
  std::uint32_t meshes = 0;
  std::uint32_t textures = 0;
  std::size_t most_vertices = 0;
};

/// Checks a chunk of a known tag, and adds it to `figures`. Chunks come in the order of their numbers.
Status check_chunk(const Chunk& chunk, ChunkFigures& figures) {
  if (chunk.tag == model_binary::kTextureTag) {
    if (chunk.number != figures.textures++) return Status::kCorrupted;
    return detail::check_texture_chunk(chunk.bytes);
  }
  if (chunk.tag != model_binary::kMeshTag) return Status::kOk;
  if (chunk.number != figures.meshes++) return Status::kCorrupted;
  const Status status = detail::check_mesh_chunk(chunk.bytes);
  if (!ok(status)) return status;
  const std::size_t vertices = detail::mesh_of_chunk(chunk.bytes.data()).vertex_count();
  if (vertices > figures.most_vertices) figures.most_vertices = vertices;
  return Status::kOk;
}

}  // namespace

std::size_t StoredModel::most_vertices() const {
  return head_ == nullptr ? 0 : static_cast<std::size_t>(little_u32(head_ + model_binary::kVerticesAt));
}

BoundingSphere StoredModel::sphere() const {
  return head_ == nullptr ? BoundingSphere{} : sphere_at(head_ + model_binary::kSphereAt);
}

ModelPart StoredModel::part(std::size_t i) const {
  ARCSPAN_CHECK(i < part_count_, "StoredModel::part: the model has no such part");
  const std::uint8_t* const record = parts_ + i * model_binary::kPartBytes;
  const std::uint16_t flags = little_u16(record + model_binary::kFlagsAt);
  const std::uint16_t texture = little_u16(record + model_binary::kTextureAt);
  ModelPart part;
  part.mesh =
      detail::mesh_of_chunk(chunks_.find(model_binary::kMeshTag, static_cast<std::uint32_t>(i)).data());
  part.material = {
      channels_at(record + model_binary::kAmbientAt), channels_at(record + model_binary::kDiffuseAt),
      channels_at(record + model_binary::kSpecularAt), little_u16(record + model_binary::kShininessAt)};
  part.two_sided = (flags & model_binary::kTwoSided) != 0;
  part.name = detail::elements_at<char>(record + model_binary::kNameAt);
  if (texture != model_binary::kNoTexture)
    part.texture = detail::texture_of_chunk(chunks_.find(model_binary::kTextureTag, texture).data());
  if ((flags & model_binary::kMasked) != 0) part.alpha = PartAlpha::kMasked;
  if ((flags & model_binary::kBlended) != 0) part.alpha = PartAlpha::kBlended;
  part.sphere = sphere_at(record + model_binary::kPartSphereAt);
  return part;
}

/// Sets the members, of a list of chunks that is valid.
Status StoredModel::find_chunks(std::span<const std::uint8_t> bytes) {
  const Status status = view_chunk_list(bytes, chunks_);
  if (!ok(status)) return status;
  const std::span<const std::uint8_t> head = chunks_.find(model_binary::kModelTag);
  const std::span<const std::uint8_t> parts = chunks_.find(model_binary::kPartsTag);
  if (head.size() != model_binary::kModelBytes || parts.data() == nullptr ||
      parts.size() % model_binary::kPartBytes != 0)
    return Status::kCorrupted;
  head_ = head.data();
  parts_ = parts.data();
  part_count_ = parts.size() / model_binary::kPartBytes;
  return Status::kOk;
}

/// Checks what is in the chunks, each once.
Status StoredModel::check() const {
  ChunkFigures figures;
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const Status status = check_chunk(chunks_[i], figures);
    if (!ok(status)) return status;
  }
  if (figures.meshes != part_count_ || figures.most_vertices != little_u32(head_ + model_binary::kVerticesAt))
    return Status::kCorrupted;
  for (std::size_t i = 0; i < part_count_; ++i) {
    if (!is_valid_part(parts_ + i * model_binary::kPartBytes, figures.textures)) return Status::kCorrupted;
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
