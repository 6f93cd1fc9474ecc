// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/scene.hpp>

namespace arcspan::tools {

RenderJob make_job(const Scene& scene, const FixedMesh& mesh, const std::string& subject) {
  const FixedCamera camera = to_fixed(place_camera(scene.camera, mesh, scene.size), mesh, scene.size);
  RenderJob job;
  job.mesh = mesh.view(subject);
  job.transform = camera.transform;
  job.to_eye = camera.to_eye;
  job.material = to_fixed(scene.surface);
  for (const SceneLight& light : scene.lights) job.lights.push_back(to_fixed(light, scene.attenuation));
  job.highlight = scene.highlight;
  job.depth = scene.depth;
  job.two_sided = scene.two_sided;
  job.segment_bits = scene.segment_bits;
  job.tolerance = scene.tolerance;
  job.background = to_rgb8(scene.background);
  job.band_rows = scene.band_rows > 0 ? scene.band_rows : scene.size.height;
  return job;
}

}  // namespace arcspan::tools
