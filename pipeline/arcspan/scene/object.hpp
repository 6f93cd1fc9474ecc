// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/bounding_sphere.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/scene/world.hpp>
#include <arcspan/vertex/orientation.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A group of triangles of a mesh that has a material of its own. It shares the vertices with the others.
struct Part {
  const SceneMaterial* material = nullptr;
  std::size_t first = 0;  ///< index of the first triangle
  std::size_t count = 0;  ///< triangles
};

/// A mesh that stands in the world. Mesh, parts and materials belong to the caller and must outlive it; an
/// object without moving parts can be a constant in flash. The members may be changed between frames.
class Object {
 public:
  /// An object of one material. Its bounding sphere is computed here from all vertices: make the mesh first,
  /// or most bands and views leave the object out.
  constexpr Object(const MeshView& mesh, const SceneMaterial& material, const WorldPoint& at = {})
      : Object(mesh, material, arcspan::bounding_sphere(mesh)) {
    position = at;
  }
  constexpr Object(const MeshView& mesh, const SceneMaterial& material, const BoundingSphere& sphere)
      : mesh_(&mesh), material_(&material), sphere_(sphere) {}
  /// An object of several materials. Triangles that no part names are not drawn.
  constexpr Object(const MeshView& mesh, std::span<const Part> parts)
      : Object(mesh, parts, arcspan::bounding_sphere(mesh)) {}
  constexpr Object(const MeshView& mesh, std::span<const Part> parts, const BoundingSphere& sphere)
      : mesh_(&mesh), parts_(parts), sphere_(sphere) {}
  // They are referred to.
  Object(MeshView&&, const SceneMaterial&, const WorldPoint& = {}) = delete;
  Object(MeshView&&, const SceneMaterial&, const BoundingSphere&) = delete;
  Object(const MeshView&, const SceneMaterial&&, const WorldPoint& = {}) = delete;
  Object(const MeshView&, const SceneMaterial&&, const BoundingSphere&) = delete;
  Object(MeshView&&, std::span<const Part>) = delete;
  Object(MeshView&&, std::span<const Part>, const BoundingSphere&) = delete;

  WorldPoint position{};                     ///< of the mesh's origin
  Rotation rotation = Rotation::identity();  ///< from object to world space, orthonormal: see rotation_of()
  WorldLength scale = WorldLength::of(1.0);  ///< world length of 32768 object units, 2^-10...32767
  bool visible = true;

  [[nodiscard]] constexpr const MeshView& mesh() const { return *mesh_; }
  [[nodiscard]] constexpr const BoundingSphere& sphere() const { return sphere_; }
  /// Sets the sphere around all vertices, for an object that is posed (PosedMaterial).
  constexpr void set_sphere(const BoundingSphere& sphere) { sphere_ = sphere; }
  /// Draws all triangles of the mesh by another material.
  constexpr void set_material(const SceneMaterial& material) { material_ = &material; }
  void set_material(const SceneMaterial&&) = delete;
  [[nodiscard]] constexpr std::size_t part_count() const { return material_ != nullptr ? 1 : parts_.size(); }
  [[nodiscard]] constexpr Part part(std::size_t i) const {
    return material_ != nullptr ? Part{material_, 0, mesh_->triangle_count()} : parts_[i];
  }
  /// The middle of the bounding sphere in world space, saturated to the range of WorldLength.
  [[nodiscard]] constexpr WorldPoint middle() const {
    const std::int64_t from_origin[3] = {sphere_.middle.x, sphere_.middle.y, sphere_.middle.z};
    const auto along = [&](std::size_t i, WorldLength origin) {
      std::int64_t sum = 0;  // 30 fraction bits, below 2^48
      for (std::size_t j = 0; j < 3; ++j) sum += from_origin[j] * rotation.m[i][j].raw();
      const std::int64_t at = origin.raw() + (((sum >> 17) * scale.raw()) >> 28);
      return WorldLength::from_raw(static_cast<std::int32_t>(at > INT32_MAX   ? INT32_MAX
                                                             : at < INT32_MIN ? INT32_MIN
                                                                              : at));
    };
    return {along(0, position.x), along(1, position.y), along(2, position.z)};
  }

 private:
  const MeshView* mesh_;
  const SceneMaterial* material_ = nullptr;
  std::span<const Part> parts_;
  BoundingSphere sphere_;
};

}  // namespace arcspan
