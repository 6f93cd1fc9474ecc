// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <arcspan_tools/fixed_point/fixed_mesh.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <optional>

namespace arcspan::tools {

/// Where a camera may be asked to stand; what is not given is chosen so that the whole model is in view.
struct CameraOptions {
  std::optional<Vec3> eye;
  std::optional<Vec3> target;
  Vec3 up{0, 1, 0};
  double fov_degrees = 40;  ///< vertical
  bool fov_given = false;   ///< whether it is the user's; otherwise place_camera() may widen it
  Vec3 view{0.5, 0.4, 1};   ///< from the target towards an eye that is not given
};

struct Camera {
  Vec3 eye;
  Vec3 target;
  Vec3 up{0, 1, 0};
  double fov_degrees = 40;
};

/// The camera that `options` means for `meshes` and a picture of `size`. Without an eye it stands in
/// direction `view`, where they just fit; without a target it looks at their centre. If they fit only from
/// farther than the pipeline's numbers reach, because the picture is very narrow, the field of view is
/// widened. Throws Failure for a field of view that was given and would have to be widened, and for a target
/// too far from them.
[[nodiscard]] Camera place_camera(const CameraOptions& options, const FixedMeshes& meshes, Size size);

/// A camera as the pipeline takes it, for one model and picture size.
struct FixedCamera {
  ClipTransform transform;
  Direction to_eye;
  Placement placement;  ///< of the model before the camera
  Projection projection;
  double nearest = 0;   ///< vertex, its distance before the camera in the model's units; negative behind it
  double farthest = 0;  ///< vertex
};

/// Throws Failure for a camera that the pipeline's numbers do not hold, or that looks nowhere.
[[nodiscard]] FixedCamera to_fixed(const Camera& camera, const FixedMeshes& meshes, Size size);

/// How far before the camera the middle of a mesh is, that of its bounding sphere, in object units.
[[nodiscard]] double distance_of(const MeshView& mesh, const Placement& placement);

/// The unit vector along `v`, which must not be zero.
[[nodiscard]] Direction to_direction(Vec3 v);

}  // namespace arcspan::tools
