// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/turntable.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arcspan::tools {
namespace {

/// `v` turned about the unit vector `axis` (Rodrigues' formula).
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
  const double cosine = std::cos(angle);
  return v * cosine + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - cosine));
}

double angle_of(std::size_t frame, std::size_t frames) {
  return -2 * std::numbers::pi * static_cast<double>(frame) / static_cast<double>(frames);
}

}  // namespace

Turntable::Turntable(const Scene& scene, const FixedMeshes& meshes, std::size_t frames)
    : base_(scene), frames_(frames) {
  const Camera first = place_camera(scene.camera, meshes, scene.size);
  target_ = first.target;
  from_target_ = first.eye - first.target;
  fov_degrees_ = first.fov_degrees;
  if (scene.camera.eye) return;
  const Vec3 axis = normalised(scene.camera.up);
  double farthest = length(from_target_);
  for (std::size_t frame = 1; frame < frames; ++frame) {
    CameraOptions options = scene.camera;
    options.view = turned(from_target_, axis, angle_of(frame, frames));
    const Camera camera = place_camera(options, meshes, scene.size);
    farthest = std::max(farthest, length(camera.eye - camera.target));
    fov_degrees_ = std::max(fov_degrees_, camera.fov_degrees);
  }
  from_target_ = normalised(from_target_) * farthest;
}

Scene Turntable::scene(std::size_t frame) const {
  const Vec3 axis = normalised(base_.camera.up);
  const double angle = angle_of(frame, frames_);
  Scene scene = base_;
  scene.camera.target = target_;
  scene.camera.fov_degrees = fov_degrees_;
  scene.camera.eye = target_ + turned(from_target_, axis, angle);
  for (SceneLight& light : scene.lights) light.towards = turned(light.towards, axis, angle);
  return scene;
}

}  // namespace arcspan::tools
