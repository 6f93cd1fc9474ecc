// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/scene.hpp>

namespace arcspan::tools {

/// `scene` after the mesh has turned by `angle` (radians) about the camera's upward direction through its
/// target: camera and lights go round the other way, which is the same picture. `start` is where
/// place_camera() put the camera.
[[nodiscard]] Scene turned(const Scene& scene, const Camera& start, double angle);

}  // namespace arcspan::tools
