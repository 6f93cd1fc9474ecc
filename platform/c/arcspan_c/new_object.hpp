// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_c/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <new>

namespace arcspan::c {

/// An object whose parts are being added behind the objects of a scene. It is in the scene after finish();
/// before, the objects of the scene are as they were.
class NewObject {
 public:
  explicit NewObject(arcspan_scene& scene) : scene_(scene) {}

  /// Adds a part with its prepared material. `made` is the index in the scene of this material, or of the one
  /// that it refers to if it is posed; kNotMade if it is in flash. `neighbours` are null if the mesh has
  /// none. Returns kBufferTooSmall if there is no room for the part.
  [[nodiscard]] Status add(const MeshView& mesh, [[maybe_unused]] const MeshNeighbours* neighbours,
                           const SceneMaterial& material, const BoundingSphere& sphere,
                           std::uint16_t made = kNotMade) {
    const std::size_t at = std::size_t{scene_.object_count} + parts_;
    if (at >= scene_.limits.objects) return Status::kBufferTooSmall;
    const MeshView& kept = *new (&scene_.meshes[at]) MeshView(mesh);
    new (&scene_.objects[at]) Object(kept, material, sphere);
#if ARCSPAN_C_OUTLINES
    const auto* const all =
        new (&scene_.neighbours[at]) MeshNeighbours(neighbours != nullptr ? *neighbours : MeshNeighbours());
    new (&scene_.outlined[at]) OutlinedMesh{&kept, all};
#endif
    scene_.parts[at] = 0;
    scene_.own[at] = scene_.shown[at] = made;
    ++parts_;
    return Status::kOk;
  }
  /// Adds a part with the material of `source`, by make().
  [[nodiscard]] Status add(const MeshView& mesh, const MeshNeighbours* neighbours,
                           const MaterialSource& source, const BoundingSphere& sphere) {
    std::uint16_t made = kNotMade;
    const Status status = make(source, made);
    return ok(status) ? add(mesh, neighbours, material(made), sphere, made) : status;
  }
  /// Sets `made` to the index of the scene's material of this source, which is prepared if no part keeps one.
  [[nodiscard]] Status make(const MaterialSource& source, std::uint16_t& made) {
    return find_or_make_material(scene_, source, {std::size_t{scene_.object_count} + parts_}, made);
  }
  /// The material with an index that make() has set.
  [[nodiscard]] const SceneMaterial& material(std::uint16_t made) const {
    return scene_.materials[made].scene_material();
  }
  /// The mesh that was added last, where the scene keeps it.
  [[nodiscard]] const MeshView& kept_mesh() const { return scene_.meshes[scene_.object_count + parts_ - 1]; }
  [[nodiscard]] arcspan_status finish(Status status, arcspan_object* object) const {
    if (ok(status) && parts_ == 0) status = Status::kInvalidArgument;
    if (!ok(status)) return static_cast<arcspan_status>(status);
    if (object != nullptr) *object = scene_.object_count;
    scene_.parts[scene_.object_count] = parts_;
    scene_.object_count = static_cast<std::uint16_t>(scene_.object_count + parts_);
    return ARCSPAN_OK;
  }

 private:
  arcspan_scene& scene_;
  std::uint16_t parts_ = 0;
};

}  // namespace arcspan::c
