// SPDX-License-Identifier: MIT
#include <arcspan/status.hpp>
#include <arcspan/version.hpp>
#include <arcspan/vertex/orientation.hpp>

#include <arcspan_c/memory.hpp>
#include <arcspan_c/scene.hpp>

#include <new>

using namespace arcspan;

static_assert(ARCSPAN_INVALID_ARGUMENT == static_cast<int>(Status::kInvalidArgument) &&
              ARCSPAN_BUFFER_TOO_SMALL == static_cast<int>(Status::kBufferTooSmall) &&
              ARCSPAN_UNSUPPORTED == static_cast<int>(Status::kUnsupported) &&
              ARCSPAN_NOT_READY == static_cast<int>(Status::kNotReady) &&
              ARCSPAN_INDEX_OUT_OF_RANGE == static_cast<int>(Status::kIndexOutOfRange) &&
              ARCSPAN_TRUNCATED == static_cast<int>(Status::kTruncated) &&
              ARCSPAN_CORRUPTED == static_cast<int>(Status::kCorrupted) &&
              ARCSPAN_NEAR_NOT_BEFORE_FAR == static_cast<int>(Status::kNearNotBeforeFar) &&
              ARCSPAN_NO_VIEW_DIRECTION == static_cast<int>(Status::kNoViewDirection) &&
              ARCSPAN_CACHE_TOO_SMALL == static_cast<int>(Status::kCacheTooSmall) &&
              ARCSPAN_SCALE_OUT_OF_RANGE == static_cast<int>(Status::kScaleOutOfRange) &&
              ARCSPAN_TOO_MANY_OBJECTS == static_cast<int>(Status::kTooManyObjects) &&
              ARCSPAN_LIGHT_CHANGED == static_cast<int>(Status::kLightChanged));

namespace {

using c::coefficients;

struct SceneParts {
  arcspan_scene* scene;
  Object* objects;
  MeshView* meshes;
#if ARCSPAN_C_OUTLINES
  MeshNeighbours* neighbours;
  OutlinedMesh* outlined;
#endif
  std::uint16_t* parts;
  std::uint16_t* own;
  std::uint16_t* shown;
  c::MadeMaterial* materials;
};

[[nodiscard]] SceneParts take_parts(c::MemoryParts& memory, const arcspan_scene_limits& limits) {
  return {
    memory.take<arcspan_scene>(), memory.take<Object>(limits.objects), memory.take<MeshView>(limits.objects),
#if ARCSPAN_C_OUTLINES
        memory.take<MeshNeighbours>(limits.objects), memory.take<OutlinedMesh>(limits.objects),
#endif
        memory.take<std::uint16_t>(limits.objects), memory.take<std::uint16_t>(limits.objects),
        memory.take<std::uint16_t>(limits.objects), memory.take<c::MadeMaterial>(limits.materials)
  };
}

constexpr SceneLight kFirstLight = SceneLight::directional(normalised(-1, 1, 2));

[[nodiscard]] SceneLight scene_light(const arcspan_light& light) {
  const Coefficient strength = Coefficient::from_raw(light.strength);
  const ChannelCoefficients colour = coefficients(light.colour);
  if (light.half != 0) {
    return SceneLight::point(c::world_point(light.at), WorldLength::from_raw(light.half), strength, colour);
  }
  return SceneLight::directional(normalised(light.at.x, light.at.y, light.at.z), strength, colour);
}

/// Whether the light is one that the library accepts (kOk) and that is compiled.
[[nodiscard]] Status check_light(const arcspan_light& light) {
  const bool has_direction = light.half != 0 || light.at.x != 0 || light.at.y != 0 || light.at.z != 0;
  if (!has_direction || !scene_light(light).valid()) return Status::kInvalidArgument;
  const bool grey = light.colour.r == light.colour.g && light.colour.g == light.colour.b;
  if (ARCSPAN_C_LIGHTS == 1 && light.half != 0) return Status::kUnsupported;
  // Also a light that is alone: materials for several lights are then made for grey ones.
  if (ARCSPAN_C_LIGHTS > 1 && ARCSPAN_C_COLOURED_LIGHTS == 0 && !grey) return Status::kUnsupported;
  return Status::kOk;
}

/// Whether materials that are prepared for either are the same.
[[nodiscard]] bool are_alike(const LightList& a, const LightList& b) {
  bool alike = a.ambient == b.ambient;
  if constexpr (ARCSPAN_C_LIGHTS == 1) {
    alike = alike && a.lights.size() == b.lights.size();
    if (alike && !a.lights.empty()) {
      alike =
          a.lights[0].strength() == b.lights[0].strength() && a.lights[0].colour() == b.lights[0].colour();
    }
  }
  return alike;
}

template <class Change>
[[nodiscard]] arcspan_status change(arcspan_scene* scene, arcspan_object object, const Change& change_part) {
  const std::span<Object> parts = scene->parts_of(object);
  for (Object& part : parts) change_part(part);
  return parts.empty() ? ARCSPAN_INVALID_ARGUMENT : ARCSPAN_OK;
}

[[nodiscard]] arcspan_status set_rotation(arcspan_scene* scene, arcspan_object object,
                                          const Rotation& rotation) {
  return change(scene, object, [&](Object& part) { part.rotation = rotation; });
}

[[nodiscard]] Quaternion quaternion(const arcspan_quaternion& q) {
  return {RotationEntry::from_raw(q.w), RotationEntry::from_raw(q.x), RotationEntry::from_raw(q.y),
          RotationEntry::from_raw(q.z)};
}

}  // namespace

const char* arcspan_version(void) { return version(); }

const char* arcspan_status_text(arcspan_status status) { return to_string(static_cast<Status>(status)); }

size_t arcspan_scene_bytes(const arcspan_scene_limits* limits) {
  c::MemoryParts parts;
  (void)take_parts(parts, *limits);
  return parts.bytes();
}

arcspan_status arcspan_scene_make(void* memory, size_t bytes, const arcspan_scene_limits* limits,
                                  arcspan_scene** scene) {
  const std::size_t wanted = arcspan_scene_bytes(limits);
  if (memory == nullptr || bytes < wanted || wanted == SIZE_MAX) return ARCSPAN_BUFFER_TOO_SMALL;
  c::MemoryParts all(memory);
  const SceneParts parts = take_parts(all, *limits);
  *scene = new (parts.scene) arcspan_scene {
    *limits, 0, 0, 1, c::all_lights(kFirstLight), kWhite, parts.objects, parts.meshes,
#if ARCSPAN_C_OUTLINES
        parts.neighbours, parts.outlined,
#endif
        parts.parts, parts.own, parts.shown, parts.materials, nullptr
  };
  return ARCSPAN_OK;
}

arcspan_status arcspan_set_lights(arcspan_scene* scene, const arcspan_light* lights, size_t count,
                                  arcspan_shares ambient) {
  if (count > ARCSPAN_C_LIGHTS) return ARCSPAN_UNSUPPORTED;
  const ChannelCoefficients ambient_light = coefficients(ambient);
  if (!arcspan::detail::in_unit_range(ambient_light)) return ARCSPAN_INVALID_ARGUMENT;
  for (std::size_t i = 0; i < count; ++i) {
    const Status status = check_light(lights[i]);
    if (!ok(status)) return static_cast<arcspan_status>(status);
  }
  const arcspan_scene before = *scene;
  for (std::size_t i = 0; i < count; ++i) scene->lights[i] = scene_light(lights[i]);
  scene->light_count = count;
  scene->ambient = ambient_light;
  if (scene->make_materials == nullptr || are_alike(before.light_list(), scene->light_list()))
    return ARCSPAN_OK;
  return static_cast<arcspan_status>(scene->make_materials(*scene));
}

arcspan_status arcspan_set_position(arcspan_scene* scene, arcspan_object object, arcspan_point position) {
  const WorldPoint at = c::world_point(position);
  return change(scene, object, [&](Object& part) { part.position = at; });
}

arcspan_status arcspan_set_scale(arcspan_scene* scene, arcspan_object object, arcspan_length scale) {
  if (scale < Camera::kLeastScale.raw()) return ARCSPAN_INVALID_ARGUMENT;
  return change(scene, object, [&](Object& part) { part.scale = WorldLength::from_raw(scale); });
}

arcspan_status arcspan_set_angles(arcspan_scene* scene, arcspan_object object, arcspan_turn yaw,
                                  arcspan_turn pitch, arcspan_turn roll) {
  return set_rotation(scene, object, rotation_of(EulerAngles{{yaw}, {pitch}, {roll}}));
}

arcspan_status arcspan_set_quaternion(arcspan_scene* scene, arcspan_object object,
                                      arcspan_quaternion rotation) {
  return set_rotation(scene, object, rotation_of(quaternion(rotation)));
}

arcspan_quaternion arcspan_multiply(arcspan_quaternion a, arcspan_quaternion b) {
  const Quaternion product = quaternion(a) * quaternion(b);
  return {product.w.raw(), product.x.raw(), product.y.raw(), product.z.raw()};
}

arcspan_status arcspan_set_visible(arcspan_scene* scene, arcspan_object object, int visible) {
  return change(scene, object, [&](Object& part) { part.visible = visible != 0; });
}
