// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene.hpp>

#include <tests/pipeline/scene/scene_support.hpp>

#include <cstdint>
#include <vector>

namespace arcspan::test {

/// A camera before random objects, some of them across the near plane or out of view.
struct RandomObjects {
  Camera camera;
  std::vector<Object> objects;
  [[nodiscard]] Scene scene() const { return {camera, kLights, objects}; }
};

[[nodiscard]] inline Camera random_camera(Random& random) {
  const auto point = [&](double size) {
    return to_point({random.real(-size, size), random.real(-size, size), random.real(-size, size)});
  };
  const Lens lens = random.chance(0.3) ? Lens::orthographic(to_world(6), to_world(0.5), to_world(30)) : kLens;
  Camera camera;
  while (!ok(Camera::make({point(8), point(2)}, lens, kScreen, camera))) continue;
  return camera;
}

/// Moves, turns and scales an object at random, at most `away` from the origin along each axis.
inline void place_at_random(Random& random, Object& object, double away) {
  const auto coordinate = [&] { return random.real(-away, away); };
  object.position = to_point({coordinate(), coordinate(), coordinate()});
  object.scale = to_world(random.decades(0.05, 3));
  object.rotation = random_rotation(random);
}

/// The same beside the eye, where clip planes cut the object: so many of its `scale` away.
inline void place_beside_eye(Random& random, Object& object, const Camera& camera, double away) {
  object.scale = to_world(random.decades(0.3, 3));
  object.position = to_point(to_vec3(camera.eye()) + away * to_double(object.scale) * random_unit(random));
  object.rotation = random_rotation(random);
}

}  // namespace arcspan::test
