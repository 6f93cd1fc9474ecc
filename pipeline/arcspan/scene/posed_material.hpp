// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/draw_options.hpp>
#include <arcspan/mesh/drawable_mesh.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/target.hpp>

#include <cstddef>

namespace arcspan {

/// An entry of a MethodList, for the objects whose vertices a Mesh poses: `M` is the method or the Use by
/// which they are drawn. All drawing code for these vertices is compiled once more than for MeshView.
template <class M, DrawableMesh Mesh>
struct Posed {
  /// @cond for draw_scene(), not in the reference
  using Used = typename detail::UseOf<M>::Type;
  using Method = typename Used::Method;
  using PosedMesh = Mesh;
  static constexpr DrawFeatures kFeatures = [] {
    DrawFeatures features = Used::kFeatures;
    features.planes = false;  // they hold for vertices that stand still
    return features;
  }();
  /// @endcond
};

/// A material of one object whose vertices a mesh poses, such as a SkinnedMesh; Posed<M, Mesh> must be listed
/// in the scene's memory. It refers to a PreparedMaterial<M>, which other objects may share, and to the mesh.
/// The pose may change between frames, before prepare_scene(), and Object::set_sphere() with it.
///
///     SkinnedMesh skinned;  // of part.mesh
///     const PosedMaterial posed(material, skinned);
///     Object walker(part.mesh, posed, posed_bound(bounds, joints));
///
/// The object's own mesh has the triangles, and as many vertices as the posed one.
template <DrawableMesh Mesh>
class PosedMaterial : public SceneMaterial {
 public:
  template <class M>
  constexpr PosedMaterial(const PreparedMaterial<M>& material, const Mesh& mesh)
      : SceneMaterial(detail::kUseFacts<Posed<typename detail::UseOf<M>::Type, Mesh>>),
        material_(&material),
        mesh_(&mesh) {}
  // They are referred to.
  template <class M>
  PosedMaterial(PreparedMaterial<M>&&, const Mesh&) = delete;
  template <class M>
  PosedMaterial(const PreparedMaterial<M>&, Mesh&&) = delete;

  /// @cond for draw_scene(), not in the reference
  [[nodiscard]] constexpr const SceneMaterial& material() const { return *material_; }
  [[nodiscard]] constexpr const Mesh& mesh() const { return *mesh_; }
  /// @endcond

 private:
  const SceneMaterial* material_;  ///< a PreparedMaterial
  const Mesh* mesh_;
};

namespace detail {

template <class M, DrawableMesh Mesh>
struct UseOf<Posed<M, Mesh>> {
  using Type = Posed<typename UseOf<M>::Type, Mesh>;
};

template <class U>
inline constexpr bool kIsPosed = false;
template <class U, DrawableMesh Mesh>
inline constexpr bool kIsPosed<Posed<U, Mesh>> = true;
template <class U>
concept IsPosed = kIsPosed<U>;

/// The PreparedMaterial of a part that is drawn by the Use U.
template <class U>
[[nodiscard]] constexpr const auto& prepared(const SceneMaterial& material) {
  if constexpr (IsPosed<U>) {
    const auto& posed = static_cast<const PosedMaterial<typename U::PosedMesh>&>(material);
    return static_cast<const PreparedMaterial<typename U::Used>&>(posed.material());
  } else {
    return static_cast<const PreparedMaterial<U>&>(material);
  }
}

/// The triangles of a part with the vertices of the posed mesh (DrawableMesh).
template <IsPosed U>
class PosedPart {
 public:
  constexpr PosedPart(const SceneMaterial& material, const MeshView& part)
      : part_(part), mesh_(static_cast<const PosedMaterial<typename U::PosedMesh>&>(material).mesh()) {}

  /// Whether the posed mesh has the vertices of the part.
  [[nodiscard]] constexpr bool fits() const { return mesh_.view().vertex_count() == part_.vertex_count(); }

  [[nodiscard]] constexpr const MeshView& view() const { return part_; }
  [[nodiscard]] ARCSPAN_INLINE ObjectPosition position(std::size_t i) const { return mesh_.position(i); }
  [[nodiscard]] ARCSPAN_INLINE Direction direction(std::size_t i) const { return mesh_.direction(i); }

 private:
  const MeshView& part_;
  const typename U::PosedMesh& mesh_;
};

/// function(mesh) of a part with the vertices that the Use U draws; `misfit` if the mesh that poses them has
/// not those of the part.
template <class U, class Result, class Function>
[[nodiscard]] ARCSPAN_INLINE constexpr Result with_vertices(const SceneMaterial& material,
                                                            const MeshView& part, const Result& misfit,
                                                            const Function& function) {
  if constexpr (IsPosed<U>) {
    const PosedPart<U> mesh(material, part);
    return mesh.fits() ? function(mesh) : misfit;
  } else {
    return function(part);
  }
}

}  // namespace detail

}  // namespace arcspan
