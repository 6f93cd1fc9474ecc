// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/fixed_point/camera.hpp>
#include <arcspan_tools/fixed_point/material.hpp>
#include <arcspan_tools/render/render.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// Fog between two distances before the camera, in the model's units, near < far.
struct SceneFog {
  double near_distance = 0;      ///< where it begins
  double far_distance = 1;       ///< where it hides everything
  std::optional<Vec3> colour{};  ///< that of the background if unset
};

/// The contents of a picture in doubles, before the conversion to fixed point.
struct Scene {
  CameraOptions camera;
  std::vector<SceneLight> lights = std::vector<SceneLight>(1, SceneLight{0.4, 0.7, 0.6});
  double attenuation = 1;  ///< K of 1 / (d + K), 1 or more
  Surface surface;
  SurfaceChoice chosen;  ///< members of `surface` that materials of a file do not replace
  Vec3 background{0.09, 0.11, 0.14};
  Highlight highlight = Highlight::kBlinn;
  Size size{320, 240};
  std::int32_t band_rows = 0;  ///< 0: the whole picture at once
  bool depth = true;
  bool two_sided = false;
  std::int32_t segment_bits = 0;  ///< as in RenderJob
  std::int32_t tolerance = 1;     ///< of `arc`, in 8-bit steps
  std::int32_t toon_steps = 0;    ///< as in RenderJob
  OutlineLook outlines;
  std::optional<double> alpha;  ///< multiplies the opacity of all surfaces, 0...1
  /// How surfaces that are not opaque are blended; with `alpha`, how all are. kNone draws them opaque.
  Transparency transparency = Transparency::kAlpha;
  std::optional<SceneFog> fog;
  std::shared_ptr<const SurfaceTexture> matcap;  ///< a picture of a shiny sphere in place of all light
};

/// `scene` with `mesh`, in fixed point. The mesh must outlive the job; `subject` names it in a Failure.
[[nodiscard]] RenderJob make_job(const Scene& scene, const FixedMesh& mesh, const std::string& subject);

/// The same for a model, with its materials. Outlines are drawn if its meshes have neighbours. Parts that
/// are blended come last, the farthest first: the one whose bounding sphere has the farthest middle, as
/// draw_scene() orders objects.
[[nodiscard]] RenderJob make_job(const Scene& scene, const FixedModel& model, const std::string& subject);

}  // namespace arcspan::tools
