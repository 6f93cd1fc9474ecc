// SPDX-License-Identifier: MIT
#include <arcspan_tools/render/scene.hpp>

#include <map>
#include <memory>

namespace arcspan::tools {
namespace {

/// Everything except the parts.
RenderJob job_without_parts(const Scene& scene, const FixedMeshes& meshes) {
  const FixedCamera camera = to_fixed(place_camera(scene.camera, meshes, scene.size), meshes, scene.size);
  RenderJob job;
  job.transform = camera.transform;
  job.to_eye = camera.to_eye;
  for (const SceneLight& light : scene.lights) job.lights.push_back(to_fixed(light, scene.attenuation));
  job.highlight = scene.highlight;
  job.depth = scene.depth;
  job.segment_bits = scene.segment_bits;
  job.tolerance = scene.tolerance;
  job.background = to_rgb8(scene.background);
  job.band_rows = scene.band_rows > 0 ? scene.band_rows : scene.size.height;
  return job;
}

}  // namespace

RenderJob make_job(const Scene& scene, const FixedMesh& mesh, const std::string& subject) {
  RenderJob job = job_without_parts(scene, mesh);
  job.parts.push_back({mesh.view(subject), to_fixed(scene.surface), scene.two_sided});
  return job;
}

RenderJob make_job(const Scene& scene, const FixedModel& model, const std::string& subject) {
  RenderJob job = job_without_parts(scene, model);
  std::map<const FileTexture*, std::shared_ptr<const SurfaceTexture>> textures;  // parts may share one
  const auto texture_of = [&textures](const FileMaterial& material) -> std::shared_ptr<const SurfaceTexture> {
    if (material.texture == nullptr) return nullptr;
    std::shared_ptr<const SurfaceTexture>& known = textures[material.texture.get()];
    if (known == nullptr) known = surface_texture(material.texture->picture);
    return known;
  };
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const FileMaterial& material = model.looks[i].material;
    job.parts.push_back({model.meshes[i].view(subject),
                         to_fixed(with_material(scene.surface, material, scene.chosen)),
                         scene.two_sided || material.two_sided, texture_of(material)});
  }
  return job;
}

}  // namespace arcspan::tools
