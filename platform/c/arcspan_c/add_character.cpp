// SPDX-License-Identifier: MIT
#include <arcspan_c/binary_part.hpp>
#include <arcspan_c/character.hpp>
#include <arcspan_c/character_material.hpp>
#include <arcspan_c/memory.hpp>
#include <arcspan_c/new_object.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

using namespace arcspan;

#if ARCSPAN_C_CHARACTERS

namespace {

using c::CharacterMaterial;
using c::CharacterMesh;

/// An animated model in a binary.
struct AnimatedModel {
  StoredModel model;
  StoredAnimation animation;

  [[nodiscard]] Status view(const void* binary, std::size_t bytes) {
    if (binary == nullptr && bytes != 0) return Status::kInvalidArgument;
    const Status status = view_model_binary({static_cast<const std::uint8_t*>(binary), bytes}, model);
    return ok(status) ? view_animation(model, animation) : status;
  }
  [[nodiscard]] std::size_t joint_count() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < animation.skin_count(); ++i) count += animation.skin(i).size();
    return count;
  }
  [[nodiscard]] std::size_t target_count() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < model.part_count(); ++i) count += animation.morph(i).target_count();
    return count;
  }
  [[nodiscard]] bool moves(std::size_t part) const {
    return animation.weights(part).exist() || animation.morph(part).target_count() != 0;
  }
};

struct CharacterMemory {
  arcspan_character* character;
  std::span<NodeMatrix> nodes;
  std::span<JointMatrix> joints;
  std::span<std::int16_t> weights;
  CharacterMesh* meshes;
  CharacterMaterial* materials;
};

[[nodiscard]] CharacterMemory take_parts(c::MemoryParts& memory, const AnimatedModel& animated) {
  const std::size_t nodes = animated.animation.nodes().size();
  const std::size_t joints = animated.joint_count();
  const std::size_t targets = animated.target_count();
  const std::size_t parts = animated.model.part_count();
  return {memory.take<arcspan_character>(),           {memory.take<NodeMatrix>(nodes), nodes},
          {memory.take<JointMatrix>(joints), joints}, {memory.take<std::int16_t>(targets), targets},
          memory.take<CharacterMesh>(parts),          memory.take<CharacterMaterial>(parts)};
}

/// Adds part `i` to an object; what moves it follows `character`.
[[nodiscard]] Status add_part(c::NewObject& object, const AnimatedModel& animated, std::size_t i,
                              const arcspan_look& look, const CharacterMemory& memory) {
  const ModelPart part = animated.model.part(i);
  MeshNeighbours neighbours;
  std::uint16_t made = c::kNotMade;
  Status status = c::find_neighbours(animated.model, i, neighbours);
  if (ok(status)) status = object.make(c::source_of(look, part.material, part.two_sided, part.texture), made);
  if (!ok(status)) return status;
  if (!animated.moves(i)) return object.add(part.mesh, &neighbours, object.material(made), part.sphere, made);
  CharacterMesh& mesh = *new (&memory.meshes[i]) CharacterMesh;
  make_posed(c::AllChoices{}, object.material(made), mesh, &memory.materials[i]);
  status = object.add(part.mesh, &neighbours, memory.materials[i], part.sphere, made);
  if (!ok(status)) return status;
  const arcspan_character& character = *memory.character;
  const StoredWeights weights = character.animation.weights(i);
  const auto joints = weights.exist() ? character.joints_of(weights.skin()) : std::span<JointMatrix>();
  return mesh.make(object.kept_mesh(), character.animation, i, joints, character.weights_of(i));
}

}  // namespace

size_t arcspan_character_bytes(const void* binary, size_t bytes) {
  AnimatedModel animated;
  if (!ok(animated.view(binary, bytes))) return 0;
  c::MemoryParts parts;
  (void)take_parts(parts, animated);
  return parts.bytes();
}

arcspan_status arcspan_add_character(arcspan_scene* scene, const void* binary, size_t bytes,
                                     const arcspan_look* look, void* memory, size_t memory_bytes,
                                     arcspan_character** character) {
  const arcspan_look& used = look != nullptr ? *look : c::kUsualLook;
  if (ARCSPAN_C_TOON == 0 && used.toon_steps != 0) return ARCSPAN_UNSUPPORTED;
  AnimatedModel animated;
  Status status = animated.view(binary, bytes);
  if (!ok(status)) return static_cast<arcspan_status>(status);
  c::MemoryParts measured;
  (void)take_parts(measured, animated);
  if (memory == nullptr || memory_bytes < measured.bytes()) return ARCSPAN_BUFFER_TOO_SMALL;
  c::MemoryParts all(memory);
  const CharacterMemory parts = take_parts(all, animated);
  arcspan_object object = 0;
  new (parts.character)
      arcspan_character{*scene, object, animated.animation, {}, parts.nodes, parts.joints, parts.weights};
  c::NewObject added(*scene);
  for (std::size_t i = 0; i < animated.model.part_count() && ok(status); ++i)
    status = add_part(added, animated, i, used, parts);
  scene->make_materials = c::make_materials;
  const arcspan_status finished = added.finish(status, &object);
  if (finished != ARCSPAN_OK) return finished;
  parts.character->object = object;
  parts.character->pose();
  *character = parts.character;
  return ARCSPAN_OK;
}

#else

size_t arcspan_character_bytes(const void*, size_t) { return 0; }

arcspan_status arcspan_add_character(arcspan_scene*, const void*, size_t, const arcspan_look*, void*, size_t,
                                     arcspan_character**) {
  return ARCSPAN_UNSUPPORTED;
}

#endif
