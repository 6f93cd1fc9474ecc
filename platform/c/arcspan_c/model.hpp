// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/scene/scene_light.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/status.hpp>

#include <arcspan.h>
#include <arcspan_c/compiled_methods.hpp>

#include <cstdint>

namespace arcspan::c {

/// A part of a model that `arcspan mesh --c` has written.
struct ModelPart {
  Status (*make_view)(MeshView& mesh);
  BoundingSphere sphere;
  const SceneMaterial* material;
  Status (*make_neighbours)(const MeshView& mesh, MeshNeighbours& neighbours) = nullptr;
};

/// The light that prepared materials in flash are made for: as many as there are lights, of strength 1.
inline constexpr SceneLight kModelLights[] = {SceneLight::directional(normalised(0, 0, 1))};

/// The method of parts with textures of the format T (void: without) in models in flash: the best one that is
/// compiled.
template <class T>
struct ModelMethod {
  template <class First, class... Others>
  static First first(ChoiceList<First, Others...>);
  using List = arcspan::c::detail::MethodsOf<true, T>;
  using Type = typename decltype(first(List{}))::Method;
};

/// The material with light in so many steps.
template <std::int32_t Steps, class M>
[[nodiscard]] consteval PreparedMaterial<M> in_steps(PreparedMaterial<M> material) {
  static_assert(Steps >= 2 && Steps <= kMostToonSteps);
  // Names Steps, so that it is only checked where the function is used.
  static_assert(Steps == 0 || Light::kHasRamp, "toon light is not for several coloured lights");
  (void)material.set_toon(Steps);
  return material;
}

}  // namespace arcspan::c

/// The type that arcspan.h declares.
struct arcspan_model {
  const arcspan::c::ModelPart* parts;
  std::uint16_t count;
};
