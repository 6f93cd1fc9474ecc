// SPDX-License-Identifier: MIT
#include <arcspan/lighting/colour_coefficients.hpp>
#include <arcspan/mesh/mesh_binary.hpp>
#include <arcspan/model/model_binary.hpp>
#include <arcspan_c/model.hpp>
#include <arcspan_c/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

using namespace arcspan;

namespace {

/// An object whose parts are being added behind the objects of a scene. It is in the scene after finish();
/// before, nothing of the scene has changed.
class NewObject {
 public:
  explicit NewObject(arcspan_scene& scene) : scene_(scene), material_count_(scene.material_count) {}

  /// Adds a part of a prepared material. Returns kBufferTooSmall if there is no room for it.
  [[nodiscard]] Status add(const MeshView& mesh, const SceneMaterial& material, const BoundingSphere& sphere) {
    const std::size_t at = std::size_t{scene_.object_count} + parts_;
    if (at >= scene_.limits.objects) return Status::kBufferTooSmall;
    const MeshView& kept = *new (&scene_.meshes[at]) MeshView(mesh);
    new (&scene_.objects[at]) Object(kept, material, sphere);
    scene_.parts[at] = 0;
    ++parts_;
    return Status::kOk;
  }
  /// Adds a part of a material that is prepared now, unless the scene has the same.
  [[nodiscard]] Status add(const MeshView& mesh, const c::MaterialSource& source, const BoundingSphere& sphere) {
    std::uint16_t i = 0;
    while (i < material_count_ && !c::is_same(scene_.materials[i].source, source)) ++i;
    if (i == scene_.limits.materials) return Status::kBufferTooSmall;
    c::MadeMaterial& made = scene_.materials[i];
    if (i == material_count_) {
      made.source = source;
      const Status status = c::make_material(made, scene_.light_list());
      if (!ok(status)) return status;
      ++material_count_;
    }
    return add(mesh, made.scene_material(), sphere);
  }
  [[nodiscard]] arcspan_status finish(Status status, arcspan_object* object) const {
    if (ok(status) && parts_ == 0) status = Status::kInvalidArgument;
    if (!ok(status)) return static_cast<arcspan_status>(status);
    if (object != nullptr) *object = scene_.object_count;
    scene_.parts[scene_.object_count] = parts_;
    scene_.object_count = static_cast<std::uint16_t>(scene_.object_count + parts_);
    scene_.material_count = material_count_;
    return ARCSPAN_OK;
  }

 private:
  arcspan_scene& scene_;
  std::uint16_t material_count_;
  std::uint16_t parts_ = 0;
};

constexpr arcspan_look kUsualLook = {ARCSPAN_ARC, 1, 0, nullptr};
constexpr Material kWhitePlastic = plastic({255, 255, 255});

[[nodiscard]] ChannelCoefficients coefficients(const arcspan_shares& s) {
  return {Coefficient::from_raw(s.r), Coefficient::from_raw(s.g), Coefficient::from_raw(s.b)};
}

[[nodiscard]] c::MaterialSource source_of(const arcspan_look& look, const Material& material, bool two_sided,
                                          const StoredTexture& texture) {
  c::MaterialSource source{material, texture, {two_sided || look.two_sided != 0}, look.method, look.tolerance};
  if (look.material != nullptr) {
    source.material = {coefficients(look.material->ambient), coefficients(look.material->diffuse),
                       coefficients(look.material->specular), look.material->shininess};
  }
  return source;
}

[[nodiscard]] Status add_mesh(NewObject& object, std::span<const std::uint8_t> binary, const arcspan_look& look) {
  MeshView mesh;
  const Status status = view_mesh_binary(binary, mesh);
  if (!ok(status)) return status;
  return object.add(mesh, source_of(look, kWhitePlastic, false, {}), bounding_sphere(mesh));
}

[[nodiscard]] Status add_parts(NewObject& object, const StoredModel& model, const arcspan_look& look) {
  for (std::size_t i = 0; i < model.part_count(); ++i) {
    const ModelPart part = model.part(i);
    const Status status =
        object.add(part.mesh, source_of(look, part.material, part.two_sided, part.texture), part.sphere);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace

arcspan_status arcspan_add_binary(arcspan_scene* scene, const void* binary, size_t bytes,
                                  const arcspan_look* look, arcspan_object* object) {
  NewObject added(*scene);
  const arcspan_look& used = look != nullptr ? *look : kUsualLook;
  const std::span data(static_cast<const std::uint8_t*>(binary), bytes);
  StoredModel model;
  Status status = view_model_binary(data, model);
  if (ok(status)) {
    status = add_parts(added, model, used);
  } else if (status == Status::kUnsupported) {  // another magic number
    status = add_mesh(added, data, used);
  }
  return added.finish(status, object);
}

arcspan_status arcspan_add_model(arcspan_scene* scene, const arcspan_model* model, arcspan_object* object) {
  NewObject added(*scene);
  Status status = Status::kOk;
  for (std::size_t i = 0; i < model->count && ok(status); ++i) {
    const c::ModelPart& part = model->parts[i];
    MeshView mesh;
    status = part.make_view(mesh);
    if (ok(status)) status = added.add(mesh, *part.material, part.sphere);
  }
  return added.finish(status, object);
}
