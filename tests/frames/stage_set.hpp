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

[[nodiscard]] inline Placement stage_placement(Turn turn) {
  constexpr Turn kTilt{4551};  // 25 degrees
  constexpr Turn kLean{2731};  // 15 degrees
  constexpr ObjectLength kEye = ObjectLength::of(-4.0 * kRadius);
  Placement placement{Rotation::about_z(kLean) * Rotation::about_x(kTilt) * Rotation::about_y(turn), {}};
  placement.translation[2] = kEye;
  return placement;
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

/// `radius`: of the silhouette of a sphere, in pixels (1...1024); `turn` about the object's own y axis.
[[nodiscard]] inline Status set_stage(const Viewport& viewport, std::int32_t radius, Turn turn,
                                      StageSet& stage) {
  const Placement placement = stage_placement(turn);
  // sqrt(15) = 3.873 radii: the tangent cone of a sphere four radii away.
  const Projection projection{PixelLength::from_raw(7932 * radius), ObjectLength::of(2.0 * kRadius),
                              ObjectLength::of(6.0 * kRadius)};
  const Status placed = ClipTransform::make(placement, projection, viewport, stage.transform);
  if (!ok(placed)) return placed;

  const Direction towards = placement.rotation.to_object(normalised(5000, 6000, 6245));
  const Direction to_eye = placement.rotation.to_object(normalised(0, 0, 1));
  return Light::make(stage_material(), {DirectionalLight{towards}}, to_eye, stage.light);
}

}  // namespace arcspan::scenes
