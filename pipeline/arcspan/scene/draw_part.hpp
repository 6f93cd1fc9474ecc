// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/numbers/copy_words.hpp>
#include <arcspan/scene/posed_material.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/scene/slot_vertices.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// The shading methods that a program draws scenes by, each a method, a Use or a Posed. Nothing
/// else is compiled.
template <class... Methods>
struct MethodList {};

namespace detail {

/// Calls function.operator()<U>() with the listed U whose facts these are. With others, or null, it does
/// nothing.
template <class... Used, class Function>
ARCSPAN_INLINE constexpr void with_use(MethodList<Used...>, const UseFacts* use, const Function& function) {
  (void)((use == &kUseFacts<Used> && (function.template operator()<Used>(), true)) || ...);
}

/// A part of an object to be drawn. `KeptRows` is PartRows or NoRows.
template <class Sink, class Depth, class KeptRows>
struct PartCall {
  SceneSlot& slot;
  const MeshView& mesh;  ///< of the part
  std::size_t number;    ///< of the part in its object
  const KeptRows& rows;
  const SceneMaterial& material;
  const ObjectLights& lights;
  const Rotation& camera;  ///< from world to view space
  Sink& sink;
  const Depth& depth;
  void* lighting;  ///< memory for the material as it is seen here
};

/// draw_mesh() with the vertices of the part's slot, which exist if `KeepsVertices`.
template <class Used, bool KeepsVertices, class Sink, class Depth, class KeptRows>
DrawResult draw_lit_part(const PartCall<Sink, Depth, KeptRows>& part,
                         const typename Used::Method::Lighting& lighting, const DrawOptions& options) {
  using Method = typename Used::Method;
  const auto draw = [&]<class Mesh>(const Mesh& mesh) {
    TriangleDrawer<Method, Used::kFeatures, Sink, Depth, Mesh> drawer(
        {mesh, part.slot.transform, lighting, shading_of(part.number)}, part.sink, part.depth, options);
    if constexpr (KeepsVertices) {
      SlotVertices<Method, KeptRows> vertices(part.slot, kUseFacts<Used>, part.rows);
      drawer.draw(vertices);
    } else {
      UncachedPart vertices(part.rows);
      drawer.draw(vertices);
    }
    return drawer.result();
  };
  return with_vertices<Used>(part.material, part.mesh, DrawResult{Status::kInvalidArgument}, draw);
}

/// Where the vertices of a part come from.
enum class PartVertices : std::uint8_t {
  kNotKept,
  kInSlot,
  kOfCurves,  ///< not kept either, and no mesh poses them
};

/// The use by which a part is drawn.
template <class Used, PartVertices>
struct DrawnUse {
  using Type = Used;
};
template <IsPosed Used>
struct DrawnUse<Used, PartVertices::kOfCurves> {
  using Type = typename Used::Used;
};

/// Whether a method draws curves over outlines (CurvedOutlines), which have neither texture points nor
/// colours.
template <class Method>
inline constexpr bool kDrawsCurves = !TakesVertexData<Method> && !DrawsEdges<Method>;

template <class Used, PartVertices Vertices, class Sink, class Depth, class KeptRows>
DrawResult draw_part_by(const PartCall<Sink, Depth, KeptRows>& part) {
  using Lighting = typename Used::Method::Lighting;
  using Drawn = typename DrawnUse<Used, Vertices>::Type;
  constexpr bool kKeepsVertices = Vertices == PartVertices::kInSlot;
  const auto& material = prepared<Used>(part.material);
  if constexpr (Vertices == PartVertices::kOfCurves && !kDrawsCurves<typename Used::Method>) {
    return {};
  } else if constexpr (Lit<Lighting>) {
    auto& lighting = *static_cast<Lighting*>(part.lighting);
    const Status status = material.light(part.lights, lighting);
    if (!ok(status)) return {status};
    return draw_lit_part<Drawn, kKeepsVertices>(part, lighting, material.options());
  } else if constexpr (FollowsView<Lighting>) {
    auto& lighting = *static_cast<Lighting*>(part.lighting);
    copy_words(material.lighting(), lighting);
    lighting.set_rotation(part.camera * part.slot.object->rotation);
    return draw_lit_part<Drawn, kKeepsVertices>(part, lighting, material.options());
  } else {
    return draw_lit_part<Drawn, kKeepsVertices>(part, material.lighting(), material.options());
  }
}

/// Draws a part by the method of its material, which is listed.
template <PartVertices Vertices, class... Used, class Sink, class Depth, class KeptRows>
DrawResult draw_part(MethodList<Used...>, const PartCall<Sink, Depth, KeptRows>& part) {
  if constexpr (sizeof...(Used) == 1) {
    return draw_part_by<Used..., Vertices>(part);
  } else {
    using Function = DrawResult (*)(const PartCall<Sink, Depth, KeptRows>&);
    struct Entry {
      const UseFacts* use;
      Function function;
    };
    static constexpr Entry kEntries[] = {{&kUseFacts<Used>, &draw_part_by<Used, Vertices, Sink, Depth>}...};
    const Entry* entry = kEntries;
    while (entry->use != part.material.use()) ++entry;
    return entry->function(part);
  }
}

}  // namespace detail

}  // namespace arcspan
