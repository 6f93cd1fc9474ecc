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

/// The source of a part's own material, with these coefficients.
[[nodiscard]] c::MaterialSource source_of(const arcspan_scene& scene, std::size_t part,
                                          const Material& material) {
  c::MaterialSource source = scene.materials[scene.own[part]].source;
  source.material = material;
  return source;
}

/// How many materials must be made for the parts first ... end - 1 of an object to be drawn by `material`.
[[nodiscard]] std::size_t wanted(const arcspan_scene& scene, const Material& material, std::size_t first,
                                 std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = first; i < end; ++i) {
    const c::MaterialSource source = source_of(scene, i, material);
    bool has = c::find_material(scene, source, {scene.object_count, first, end}) != c::kNotMade;
    for (std::size_t j = first; j < i && !has; ++j) has = c::is_same(source_of(scene, j, material), source);
    if (!has) ++count;
  }
  return count;
}

/// Whether so many materials can be made.
[[nodiscard]] bool has_room(const arcspan_scene& scene, std::size_t count, std::size_t first,
                            std::size_t end) {
  std::size_t free = scene.limits.materials;
  for (std::uint16_t i = 0; i < scene.material_count; ++i) {
    if (c::is_kept(scene, i, {scene.object_count, first, end})) --free;
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

}  // namespace

arcspan_status arcspan_set_material(arcspan_scene* scene, arcspan_object object,
                                    const arcspan_material* material) {
  const std::size_t first = object;
  const std::size_t end = first + scene->parts_of(object).size();
  if (first == end) return ARCSPAN_INVALID_ARGUMENT;
  for (std::size_t i = first; i < end; ++i) {
    if (scene->own[i] == c::kNotMade) return ARCSPAN_UNSUPPORTED;
  }
  if (material == nullptr) {
    for (std::size_t i = first; i < end; ++i) show(*scene, i, scene->own[i]);
    return ARCSPAN_OK;
  }
  const Material set = c::material_of(*material);
  if (!arcspan::detail::in_range(set)) return ARCSPAN_INVALID_ARGUMENT;
  if (!has_room(*scene, wanted(*scene, set, first, end), first, end)) return ARCSPAN_BUFFER_TOO_SMALL;
  for (std::size_t i = first; i < end; ++i) {
    std::uint16_t index = c::kNotMade;
    const Status status =
        c::find_or_make_material(*scene, source_of(*scene, i, set), {scene->object_count, i, end}, index);
    if (!ok(status)) return static_cast<arcspan_status>(status);  // not reached: the rest is as in its own
    show(*scene, i, index);
  }
  return ARCSPAN_OK;
}
