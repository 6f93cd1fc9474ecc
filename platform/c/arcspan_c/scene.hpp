// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/scene_light.hpp>
#include <arcspan/scene_outlines.hpp>
#include <arcspan/texture/texture_binary.hpp>

#include <arcspan.h>
#include <arcspan_c/compiled_methods.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace arcspan::c {

/// The largest PreparedMaterial.
template <class... C>
[[nodiscard]] consteval std::size_t material_bytes(ChoiceList<C...>) {
  std::size_t most = 0;
  for (const std::size_t bytes : {sizeof(PreparedMaterial<typename C::Method>)...}) {
    if (bytes > most) most = bytes;
  }
  return most;
}

[[nodiscard]] constexpr WorldPoint world_point(const arcspan_point& p) {
  return {WorldLength::from_raw(p.x), WorldLength::from_raw(p.y), WorldLength::from_raw(p.z)};
}
[[nodiscard]] constexpr ChannelCoefficients coefficients(const arcspan_shares& s) {
  return {Coefficient::from_raw(s.r), Coefficient::from_raw(s.g), Coefficient::from_raw(s.b)};
}

/// The opacity of what hides all that is behind it.
inline constexpr std::uint8_t kOpaque = 32;

/// The data from which a material of a part of a binary is prepared.
struct MaterialSource {
  Material material;
  StoredTexture texture;  ///< its texels are empty if there is none
  DrawOptions options;
  arcspan_method method;
  std::uint8_t tolerance;
  std::uint8_t opacity = kOpaque;
#if ARCSPAN_C_TOON
  std::uint8_t toon_steps = 0;
#endif
};

/// A material that is prepared at run time.
struct MadeMaterial {
  MaterialSource source;
  alignas(8) unsigned char prepared[material_bytes(AllChoices{})];  ///< a PreparedMaterial

  [[nodiscard]] const SceneMaterial& scene_material() const {
    return *static_cast<const SceneMaterial*>(static_cast<const void*>(prepared));
  }
};

/// Makes `made.prepared` of its source for the lights. Returns kUnsupported for a method, texture or light in
/// steps that is not compiled, else the status of PreparedMaterial::make(), set_tolerance() or set_toon().
[[nodiscard]] Status make_material(MadeMaterial& made, const LightList& lights);

/// make_material() for all that parts keep, after the lights have changed (arcspan_scene::make_materials).
[[nodiscard]] Status make_materials(arcspan_scene& scene);

/// In place of the index of a material that was made: it is in flash, or there is none.
inline constexpr std::uint16_t kNotMade = 0xFFFF;

/// Parts of a scene whose materials stay: those before `end` keep their own and the shown one, of which the
/// parts first_changed ... end_changed - 1 keep only their own, because they get another one.
struct KeepingParts {
  std::size_t end;
  std::size_t first_changed = 0;
  std::size_t end_changed = 0;
};
/// Whether one of these parts keeps the material with this index.
[[nodiscard]] bool is_kept(const arcspan_scene& scene, std::uint16_t index, const KeepingParts& parts);
/// Returns the index of the material of this source that a part keeps; kNotMade if there is none.
[[nodiscard]] std::uint16_t find_material(const arcspan_scene& scene, const MaterialSource& source,
                                          const KeepingParts& parts);
/// Sets `index` to find_material(), or to a material that no part keeps, and which is prepared. Returns
/// kBufferTooSmall if there is none, or the status of make_material().
[[nodiscard]] Status find_or_make_material(arcspan_scene& scene, const MaterialSource& source,
                                           const KeepingParts& parts, std::uint16_t& index);

/// The array of a scene's lights, each of which is `light`.
[[nodiscard]] constexpr std::array<SceneLight, ARCSPAN_C_LIGHTS> all_lights(const SceneLight& light) {
  return []<std::size_t... I>(const SceneLight& one, std::index_sequence<I...>) {
    return std::array{(static_cast<void>(I), one)...};
  }
  (light, std::make_index_sequence<ARCSPAN_C_LIGHTS>());
}

[[nodiscard]] constexpr bool is_same(const Material& a, const Material& b) {
  return a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
         a.shininess == b.shininess;
}
/// Whether both would be prepared alike.
[[nodiscard]] bool is_same(const MaterialSource& a, const MaterialSource& b);

}  // namespace arcspan::c

/// The type that arcspan.h declares. Arrays have the lengths of `limits`.
struct arcspan_scene {
  arcspan_scene_limits limits;
  std::uint16_t object_count;
  std::uint16_t material_count;  ///< that have been made, whether or not a part keeps them
  std::size_t light_count;
  std::array<arcspan::SceneLight, ARCSPAN_C_LIGHTS> lights;
  arcspan::ChannelCoefficients ambient;
  arcspan::Object* objects;
  arcspan::MeshView* meshes;  ///< of the objects
#if ARCSPAN_C_OUTLINES
  arcspan::MeshNeighbours* neighbours;  ///< of the meshes
  arcspan::OutlinedMesh* outlined;      ///< both
#endif
  std::uint16_t* parts;  ///< at an object's first part the number of its parts, at its others 0
  std::uint16_t* own;    ///< of each part, the index of the material that it was added with, or kNotMade
  std::uint16_t* shown;  ///< of each part, the index of the material that it is drawn by, or kNotMade
  arcspan::c::MadeMaterial* materials;
  /// Set by arcspan_add_binary(), so that programs with models in flash only do not hold its code.
  arcspan::Status (*make_materials)(arcspan_scene& scene);

  [[nodiscard]] arcspan::LightList light_list() const {
    return {std::span<const arcspan::SceneLight>(lights).first(light_count), ambient};
  }
  /// The parts of an object; none if there is no such object.
  [[nodiscard]] std::span<arcspan::Object> parts_of(arcspan_object object) const {
    if (object >= object_count) return {};
    return {objects + object, parts[object]};
  }
};
