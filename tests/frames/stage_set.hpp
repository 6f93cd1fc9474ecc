// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <tests/frames/integer_shapes.hpp>

namespace arcspan::scenes {

/// Camera and light of the project's measured scene: the object tilted 25 degrees about x and then 15 about
/// z, the eye four radii away, one light from (0.5, 0.6, 0.6245), colour (220, 140, 70) / 255, ambient 0.2,
/// diffuse 0.8, white specular 0.5 with n = 16 of R·V.
using Light = Illumination<1, Highlight::kPhong>;

struct StageSet {
  ClipTransform transform;
  Light light;
};

/// The rotation of the measured scene; `turn` about the object's own y axis.
[[nodiscard]] inline Rotation stage_rotation(Turn turn) {
  constexpr Turn kTilt{4551};  // 25 degrees
  constexpr Turn kLean{2731};  // 15 degrees
  return Rotation::about_z(kLean) * Rotation::about_x(kTilt) * Rotation::about_y(turn);
}

[[nodiscard]] inline Material stage_material() {
  Material material;
  material.ambient = {Coefficient::of(0.2 * 220 / 255), Coefficient::of(0.2 * 140 / 255),
                      Coefficient::of(0.2 * 70 / 255)};
  material.diffuse = {Coefficient::of(0.8 * 220 / 255), Coefficient::of(0.8 * 140 / 255),
                      Coefficient::of(0.8 * 70 / 255)};
  material.specular = {Coefficient::of(0.5), Coefficient::of(0.5), Coefficient::of(0.5)};
  material.shininess = 16;
  return material;
}

/// Sets camera and light for an object within a sphere of radius kRadius, `eye` such radii before the camera.
[[nodiscard]] inline Status set_stage(const Viewport& viewport, PixelLength focal, std::int32_t eye,
                                      const Rotation& rotation, StageSet& stage) {
  static constexpr ObjectLength kOne = ObjectLength::of(1.0 * kRadius);
  const auto radii = [](std::int32_t count) { return ObjectLength::from_raw(kOne.raw() * count); };
  Placement placement{rotation, {}};
  placement.translation[2] = radii(-eye);
  const Projection projection{focal, radii(eye - 2), radii(eye + 2)};
  const Status placed = ClipTransform::make(placement, projection, viewport, stage.transform);
  if (!ok(placed)) return placed;

  const Direction towards = rotation.to_object(normalised(5000, 6000, 6245));
  const Direction to_eye = rotation.to_object(normalised(0, 0, 1));
  return Light::make(stage_material(), {DirectionalLight{towards}}, to_eye, stage.light);
}

/// `radius`: of the silhouette of a sphere, in pixels (1...1024); `turn` about the object's own y axis.
[[nodiscard]] inline Status set_stage(const Viewport& viewport, std::int32_t radius, Turn turn,
                                      StageSet& stage) {
  // sqrt(15) = 3.873 radii: the tangent cone of a sphere four radii away.
  return set_stage(viewport, PixelLength::from_raw(7932 * radius), 4, stage_rotation(turn), stage);
}

/// The stage of a standing figure within a sphere of radius kRadius, turned by 30 degrees, five radii away.
[[nodiscard]] inline Status set_character_stage(const Viewport& viewport, StageSet& stage) {
  constexpr Turn kYaw{5461};
  constexpr PixelLength kFocal = PixelLength::from_raw(std::int32_t{7932} * 219);
  return set_stage(viewport, kFocal, 5, Rotation::about_y(kYaw), stage);
}

}  // namespace arcspan::scenes
