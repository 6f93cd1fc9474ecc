// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/draw/kept_vertices.hpp>
#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/numbers/copy_words.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <cstddef>

namespace arcspan {

/// The shading methods that a program draws scenes by, each a method or a Use. Nothing else is compiled.
template <class... Methods>
struct MethodList {};

namespace detail {

/// A part of an object to be drawn.
template <class Sink, class Depth>
struct PartCall {
  SceneSlot& slot;
  const MeshView& mesh;
  const SceneMaterial& material;
  const ObjectLights& lights;
  const Rotation& camera;  ///< from world to view space
  Sink& sink;
  const Depth& depth;
  void* lighting;  ///< memory for the material as it is seen here
};

/// Makes the vertices of a slot ready for a part that `use` draws. They stay from part to part and from band
/// to band, unless another use has written them.
template <class Method>
void hold_vertices(SceneSlot& slot, const UseFacts& use, CachedVertex<Method>* vertices) {
  const std::size_t count = slot.object->mesh().vertex_count();
  if (slot.held != &use) {
    forget_vertices(vertices, count);
    slot.held = &use;
  } else if (!SharesVertices<Method> && slot.object->part_count() > 1) {
    for (std::size_t i = 0; i < count; ++i) vertices[i].shaded = false;
  }
}

/// draw_mesh() with the vertices of the part's slot, which exist if `KeepsVertices`.
template <class Used, bool KeepsVertices, class Sink, class Depth>
DrawResult draw_lit_part(const PartCall<Sink, Depth>& part, const typename Used::Method::Lighting& lighting) {
  using Method = typename Used::Method;
  const DrawOptions& options = part.material.options();
  if constexpr (KeepsVertices && Used::kFeatures.caches) {
    TriangleDrawer<Method, Used::kFeatures, Sink, Depth> drawer(part.mesh, part.slot.transform, lighting,
                                                                part.sink, part.depth, options);
    if (!drawer.ready()) return drawer.result();
    const VisibleTriangles visible = drawer.visible_triangles();
    if (visible.excludes_all()) return drawer.result();
    auto* const vertices = static_cast<CachedVertex<Method>*>(static_cast<void*>(part.slot.vertices));
    hold_vertices<Method>(part.slot, kUseFacts<Used>, vertices);
    if (visible.known()) {
      drawer.draw_triangles_outlined(FrontVertices<Method>(drawer.stage(), vertices, visible));
    } else {
      drawer.draw_triangles_outlined(
          KeptVertices<Method>(drawer.stage(), vertices, nullptr, visible, drawer.scissor().rect()));
    }
    return drawer.result();
  } else {
    constexpr DrawFeatures kFeatures = [] {
      DrawFeatures features = Used::kFeatures;
      features.caches = false;
      return features;
    }();
    return draw_mesh<Method, kFeatures>(part.mesh, part.slot.transform, lighting, part.sink, part.depth, {},
                                        options);
  }
}

template <class Used, bool KeepsVertices, class Sink, class Depth>
DrawResult draw_part_by(const PartCall<Sink, Depth>& part) {
  using Lighting = typename Used::Method::Lighting;
  const auto& material = static_cast<const PreparedMaterial<Used>&>(part.material);
  if constexpr (Lit<Lighting>) {
    auto& lighting = *static_cast<Lighting*>(part.lighting);
    const Status status = material.light(part.lights, lighting);
    if (!ok(status)) return {status};
    return draw_lit_part<Used, KeepsVertices>(part, lighting);
  } else if constexpr (FollowsView<Lighting>) {
    auto& lighting = *static_cast<Lighting*>(part.lighting);
    copy_words(material.lighting(), lighting);
    lighting.set_rotation(part.camera * part.slot.object->rotation);
    return draw_lit_part<Used, KeepsVertices>(part, lighting);
  } else {
    return draw_lit_part<Used, KeepsVertices>(part, material.lighting());
  }
}

/// Draws a part by the method of its material, which is listed.
template <bool KeepsVertices, class... Used, class Sink, class Depth>
DrawResult draw_part(MethodList<Used...>, const PartCall<Sink, Depth>& part) {
  if constexpr (sizeof...(Used) == 1) {
    return draw_part_by<Used..., KeepsVertices>(part);
  } else {
    using Function = DrawResult (*)(const PartCall<Sink, Depth>&);
    struct Entry {
      const UseFacts* use;
      Function function;
    };
    static constexpr Entry kEntries[] = {
        {&kUseFacts<Used>, &draw_part_by<Used, KeepsVertices, Sink, Depth>}...};
    const Entry* entry = kEntries;
    while (entry->use != part.material.use()) ++entry;
    return entry->function(part);
  }
}

}  // namespace detail

}  // namespace arcspan
