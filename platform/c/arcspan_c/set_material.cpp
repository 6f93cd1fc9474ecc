// SPDX-License-Identifier: MIT
#include <arcspan/lighting/check_light.hpp>

#include <arcspan_c/binary_part.hpp>
#include <arcspan_c/scene.hpp>

#if ARCSPAN_C_CHARACTERS
#include <arcspan_c/character_material.hpp>
#endif

#include <cstddef>
#include <cstdint>

using namespace arcspan;

namespace {

/// The parts of an object, by their places in the scene.
struct PartRange {
  std::size_t first;
  std::size_t end;
};

/// How all parts of an object are drawn.
struct Drawn {
  bool by_own;        ///< each by its own material
  Material material;  ///< otherwise all by this one
  std::uint8_t opacity;
};

/// How the parts of an object are drawn now.
[[nodiscard]] Drawn drawn_now(const arcspan_scene& scene, const PartRange& parts) {
  Drawn drawn{true, {}, scene.materials[scene.shown[parts.first]].source.opacity};
  for (std::size_t i = parts.first; i < parts.end && drawn.by_own; ++i) {
    drawn.material = scene.materials[scene.shown[i]].source.material;
    drawn.by_own = c::is_same(drawn.material, scene.materials[scene.own[i]].source.material);
  }
  return drawn;
}

/// The source of the material by which a part is drawn then.
[[nodiscard]] c::MaterialSource source_of(const arcspan_scene& scene, std::size_t part, const Drawn& drawn) {
  c::MaterialSource source = scene.materials[scene.own[part]].source;
  if (!drawn.by_own) source.material = drawn.material;
  source.opacity = drawn.opacity;
  return source;
}

/// How many materials must be made for the parts of an object to be drawn so.
[[nodiscard]] std::size_t wanted(const arcspan_scene& scene, const Drawn& drawn, const PartRange& parts) {
  std::size_t count = 0;
  for (std::size_t i = parts.first; i < parts.end; ++i) {
    const c::MaterialSource source = source_of(scene, i, drawn);
    bool has = c::find_material(scene, source, {scene.object_count, parts.first, parts.end}) != c::kNotMade;
    for (std::size_t j = parts.first; j < i && !has; ++j)
      has = c::is_same(source_of(scene, j, drawn), source);
    if (!has) ++count;
  }
  return count;
}

/// Whether so many materials can be made.
[[nodiscard]] bool has_room(const arcspan_scene& scene, std::size_t count, const PartRange& parts) {
  std::size_t free = scene.limits.materials;
  for (std::uint16_t i = 0; i < scene.material_count; ++i) {
    if (c::is_kept(scene, i, {scene.object_count, parts.first, parts.end})) --free;
  }
  return count <= free;
}

/// Draws a part by the material with this index.
void show(arcspan_scene& scene, std::size_t part, std::uint16_t index) {
  Object& object = scene.objects[part];
  const SceneMaterial& material = scene.materials[index].scene_material();
  [[maybe_unused]] const SceneMaterial* const before = object.part(0).material;
  [[maybe_unused]] const bool poses = before != &scene.materials[scene.shown[part]].scene_material();
  scene.shown[part] = index;
#if ARCSPAN_C_CHARACTERS
  if (poses) {
    auto* const posed = static_cast<c::CharacterMaterial*>(const_cast<SceneMaterial*>(before));
    c::make_posed(c::AllChoices{}, material, posed->mesh(), posed);
    return;
  }
#endif
  object.set_material(material);
}

/// Draws the parts of an object so; if there is no room, they are drawn as before.
[[nodiscard]] arcspan_status draw_as(arcspan_scene& scene, const Drawn& drawn, const PartRange& parts) {
  if (!has_room(scene, wanted(scene, drawn, parts), parts)) return ARCSPAN_BUFFER_TOO_SMALL;
  for (std::size_t i = parts.first; i < parts.end; ++i) {
    const c::MaterialSource source = source_of(scene, i, drawn);
    std::uint16_t index = scene.shown[i];
    if (!c::is_same(source, scene.materials[index].source)) {
      const Status status =
          c::find_or_make_material(scene, source, {scene.object_count, i, parts.end}, index);
      if (!ok(status)) return static_cast<arcspan_status>(status);  // not reached: there is room
    }
    show(scene, i, index);  // in any case: an earlier part may have made it anew, for another method
  }
  return ARCSPAN_OK;
}

/// Sets `parts` to those of an object. Returns the status of arcspan_set_material() if there is no such
/// object, or if it has materials in flash.
[[nodiscard]] arcspan_status find_parts(const arcspan_scene& scene, arcspan_object object, PartRange& parts) {
  parts = {object, object + scene.parts_of(object).size()};
  if (parts.first == parts.end) return ARCSPAN_INVALID_ARGUMENT;
  for (std::size_t i = parts.first; i < parts.end; ++i) {
    if (scene.own[i] == c::kNotMade) return ARCSPAN_UNSUPPORTED;
  }
  return ARCSPAN_OK;
}

}  // namespace

arcspan_status arcspan_set_material(arcspan_scene* scene, arcspan_object object,
                                    const arcspan_material* material) {
  PartRange parts{};
  const arcspan_status status = find_parts(*scene, object, parts);
  if (status != ARCSPAN_OK) return status;
  Drawn drawn = drawn_now(*scene, parts);
  drawn.by_own = material == nullptr;
  if (material != nullptr) {
    drawn.material = c::material_of(*material);
    if (!arcspan::detail::in_range(drawn.material)) return ARCSPAN_INVALID_ARGUMENT;
  }
  return draw_as(*scene, drawn, parts);
}

arcspan_status arcspan_set_opacity([[maybe_unused]] arcspan_scene* scene,
                                   [[maybe_unused]] arcspan_object object,
                                   [[maybe_unused]] arcspan_share opacity) {
#if ARCSPAN_C_OPACITY
  PartRange parts{};
  const arcspan_status status = find_parts(*scene, object, parts);
  if (status != ARCSPAN_OK) return status;
  if (opacity > ARCSPAN_SHARE(1)) return ARCSPAN_INVALID_ARGUMENT;
  Drawn drawn = drawn_now(*scene, parts);
  drawn.opacity = static_cast<std::uint8_t>((opacity + 512) >> 10);
  return draw_as(*scene, drawn, parts);
#else
  return ARCSPAN_UNSUPPORTED;
#endif
}
