// SPDX-License-Identifier: MIT
// The random scenes in which scripts/firmware-costs compares methods. scripts/lib/random_scenes.py writes
// them, and the emulator loads them into the program's memory.
#pragma once

#include <tests/frames/stage_set.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A sphere, its place and its light.
struct RandomScene {
  std::uint32_t segments;  ///< 0 after the last scene
  std::uint32_t rings;
  std::int32_t shininess;        ///< exponent of the highlight
  std::int32_t turns[3];         ///< Turn about z, x and y, the factors of the rotation
  std::int32_t translation[3];   ///< ObjectLength
  std::int32_t near_plane;       ///< ObjectLength
  std::int32_t far_plane;        ///< ObjectLength
  std::int32_t focal;            ///< PixelLength
  std::int32_t to_lights[2][3];  ///< vectors of any length in view space
};

/// Camera and light of a scene: one light of full strength, or two grey ones of 0.7 and 0.5.
template <std::size_t Lights, Highlight Model>
[[nodiscard]] Status set_random_stage(const RandomScene& scene, const Viewport& viewport,
                                      ClipTransform& transform, Illumination<Lights, Model>& light) {
  const auto turn = [&](std::size_t i) { return Turn{static_cast<std::uint16_t>(scene.turns[i])}; };
  const Rotation rotation =
      Rotation::about_z(turn(0)) * Rotation::about_x(turn(1)) * Rotation::about_y(turn(2));
  const auto& t = scene.translation;
  const Placement placement{
      rotation, {ObjectLength::from_raw(t[0]), ObjectLength::from_raw(t[1]), ObjectLength::from_raw(t[2])}};
  const Projection projection{PixelLength::from_raw(scene.focal), ObjectLength::from_raw(scene.near_plane),
                              ObjectLength::from_raw(scene.far_plane)};
  const Status placed = ClipTransform::make(placement, projection, viewport, transform);
  if (!ok(placed)) return placed;

  constexpr Coefficient kStrengths[] = {Coefficient::of(0.7), Coefficient::of(0.5)};
  std::array<DirectionalLight, Lights> lights{};
  for (std::size_t i = 0; i < Lights; ++i) {
    const auto& towards = scene.to_lights[i];
    lights[i].towards = rotation.to_object(normalised(towards[0], towards[1], towards[2]));
    if (Lights > 1) lights[i].strength = kStrengths[i];
  }
  Material material = scenes::stage_material();
  material.shininess = scene.shininess;
  return Illumination<Lights, Model>::make(material, lights,
                                           rotation.to_object(normalised(-t[0], -t[1], -t[2])), light);
}

}  // namespace arcspan
