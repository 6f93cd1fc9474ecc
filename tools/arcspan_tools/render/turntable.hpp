// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/render/scene.hpp>

#include <cstddef>

namespace arcspan::tools {

/// A scene whose mesh turns on the spot, counter-clockwise seen from the end of the up axis, while camera and
/// lights stand still. Pictures are made the other way round, by turning camera and lights about the mesh,
/// which looks the same. If the camera may choose its place, it stands where the mesh fits at every angle.
class Turntable {
 public:
  Turntable(const Scene& scene, const FixedMeshes& meshes, std::size_t frames);

  /// The scene after `frame` of `frames` parts of a turn.
  [[nodiscard]] Scene scene(std::size_t frame) const;

 private:
  Scene base_;
  Vec3 target_;
  Vec3 from_target_;  ///< of the eye, at first
  double fov_degrees_;
  std::size_t frames_;
};

}  // namespace arcspan::tools
