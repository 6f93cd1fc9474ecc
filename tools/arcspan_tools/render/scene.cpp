// SPDX-License-Identifier: MIT
#include <arcspan/texture/texture_binary.hpp>

#include <arcspan_tools/fixed_point/rounding.hpp>
#include <arcspan_tools/render/scene.hpp>
#include <arcspan_tools/support/failure.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

namespace arcspan::tools {
namespace {

/// A job and the camera that it is drawn by.
struct Placed {
  RenderJob job;
  FixedCamera camera;
};

std::shared_ptr<const Fog> make_fog(const Scene& scene, const FixedMeshes& meshes,
                                    const Projection& projection) {
  if (!scene.fog) return nullptr;
  static constexpr double kMost = 4'194'303;  // farther away nothing is drawn
  const auto raw = [&meshes](double distance) {
    const double units = std::clamp(distance / meshes.unit(), -kMost, kMost);
    return to_fixed_point<ObjectLength>(units).value().raw();
  };
  auto fog = std::make_shared<Fog>();
  const FogRange range{projection.near_plane.raw(), projection.far_plane.raw(), raw(scene.fog->near_distance),
                       raw(scene.fog->far_distance)};
  if (!ok(Fog::make(range, to_rgb8(scene.fog->colour.value_or(scene.background)), *fog))) {
    throw Failure("--fog", "both distances are one for a model of this size");
  }
  return fog;
}

/// Everything except the parts.
Placed job_without_parts(const Scene& scene, const FixedMeshes& meshes) {
  Placed placed;
  placed.camera = to_fixed(place_camera(scene.camera, meshes, scene.size), meshes, scene.size);
  const FixedCamera& camera = placed.camera;
  RenderJob& job = placed.job;
  job.transform = camera.transform;
  job.to_eye = camera.to_eye;
  job.rotation = camera.placement.rotation;
  for (const SceneLight& light : scene.lights) job.lights.push_back(to_fixed(light, scene.attenuation));
  job.highlight = scene.highlight;
  job.depth = scene.depth;
  job.segment_bits = scene.segment_bits;
  job.tolerance = scene.tolerance;
  job.toon_steps = scene.toon_steps;
  job.outlines = scene.outlines;
  job.background = to_rgb8(scene.background);
  job.band_rows = scene.band_rows > 0 ? scene.band_rows : scene.size.height;
  job.fog = make_fog(scene, meshes, camera.projection);
  job.matcap = scene.matcap;
  job.nearest = camera.nearest;
  job.farthest = camera.farthest;
  return placed;
}

/// Makes a part transparent as far as the scene and its material say.
void set_transparency(const Scene& scene, const FileMaterial& material, RenderPart& part) {
  const double opacity = std::clamp(scene.alpha.value_or(1) * material.opacity, 0.0, 1.0);
  const bool by_texture = material.texture != nullptr && material.alpha_mode == AlphaMode::kBlend;
  if (scene.alpha || opacity < 1 || by_texture) part.transparency = scene.transparency;
  const double whole = part.transparency == Transparency::kScreenDoor ? 8 : 32;
  part.opacity = part.transparency == Transparency::kNone
                     ? std::uint8_t{32}
                     : static_cast<std::uint8_t>(std::lround(opacity * whole));
}

/// The bits of alpha of the texture that a firmware would have for the part.
unsigned alpha_bits(const FileMaterial& material, Transparency transparency) {
  if (material.alpha_mode == AlphaMode::kOpaque) return 0;
  if (material.alpha_mode == AlphaMode::kMask) return 1;
  return transparency == Transparency::kNone ? 0 : 4;
}

/// Textures of parts, each made once.
class PartTextures {
 public:
  explicit PartTextures(const FixedModel& model) : model_(model) {}

  std::shared_ptr<const SurfaceTexture> of(const FileMaterial& material, Transparency transparency) {
    if (material.texture == nullptr) return nullptr;
    const unsigned bits = alpha_bits(material, transparency);
    const double cutoff = bits == 1 ? material.alpha_cutoff : 0;
    std::shared_ptr<const SurfaceTexture>& known =
        known_[{material.texture.get(), bits, cutoff, texture_binary::sampler_byte(material.sampler)}];
    if (known == nullptr) {
      known = surface_texture_of(material, bits, islands_of(model_, *material.texture));
    }
    return known;
  }

 private:
  const FixedModel& model_;
  using Key = std::tuple<const FileTexture*, unsigned, double, std::uint8_t>;
  std::map<Key, std::shared_ptr<const SurfaceTexture>> known_;
};

/// Puts blended parts behind the others, the farthest first.
void order_parts(RenderJob& job, const Placement& placement) {
  const auto first = std::stable_partition(job.parts.begin(), job.parts.end(), [](const RenderPart& part) {
    return !is_blended(part.transparency);
  });
  std::stable_sort(first, job.parts.end(), [&placement](const RenderPart& a, const RenderPart& b) {
    return distance_of(a.mesh, placement) > distance_of(b.mesh, placement);
  });
}

/// The neighbours of a mesh for outlines, if it has some.
MeshNeighbours neighbours_in(const FixedMesh& mesh, const MeshView& view, const std::string& subject) {
  MeshNeighbours neighbours;
  if (mesh.neighbours.empty()) return neighbours;
  const Status status = MeshNeighbours::make(view, mesh.neighbours, neighbours);
  if (!ok(status)) throw Failure(subject, to_string(status));
  return neighbours;
}

}  // namespace

RenderJob make_job(const Scene& scene, const FixedMesh& mesh, const std::string& subject) {
  Placed placed = job_without_parts(scene, mesh);
  placed.job.parts.push_back({mesh.view(subject), to_fixed(scene.surface), scene.two_sided});
  set_transparency(scene, {}, placed.job.parts[0]);
  return std::move(placed.job);
}

RenderJob make_job(const Scene& scene, const FixedModel& model, const std::string& subject) {
  Placed placed = job_without_parts(scene, model);
  PartTextures textures(model);
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const FileMaterial& material = model.looks[i].material;
    RenderPart part{model.meshes[i].view(subject),
                    to_fixed(with_material(scene.surface, material, scene.chosen)),
                    scene.two_sided || material.two_sided};
    set_transparency(scene, material, part);
    part.texture = textures.of(material, part.transparency);
    part.neighbours = neighbours_in(model.meshes[i], part.mesh, subject);
    part.vertex_colours = !model.meshes[i].colours.empty() && !scene.chosen.colour;
    if (part.vertex_colours && scene.toon_steps != 0)
      throw Failure("--toon", "interpolated vertex colours have no steps: add --no-vertex-colours");
    placed.job.parts.push_back(std::move(part));
  }
  order_parts(placed.job, placed.camera.placement);
  return std::move(placed.job);
}

}  // namespace arcspan::tools
