// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_drawer.hpp>
#include <arcspan/draw/vertex_source.hpp>
#include <arcspan/numbers/copy_words.hpp>
#include <arcspan/scene/posed_material.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// The shading methods that a program draws scenes by, each a method, a Use or a Posed. Nothing
/// else is compiled.
template <class... Methods>
struct MethodList {};

namespace detail {

/// A part of an object to be drawn.
template <class Sink, class Depth>
struct PartCall {
  SceneSlot& slot;
  const MeshView& mesh;  ///< of the part
  std::size_t number;    ///< of the part in its object
  const SceneMaterial& material;
  const ObjectLights& lights;
  const Rotation& camera;  ///< from world to view space
  Sink& sink;
  const Depth& depth;
  void* lighting;  ///< memory for the material as it is seen here
};

/// The vertices of a slot (VertexSource). They stay from part to part and from band to band, unless another
/// use has written them.
template <class Method>
class SlotVertices {
 public:
  SlotVertices(SceneSlot& slot, const UseFacts& use)
      : slot_(slot),
        use_(use),
        vertices_(static_cast<CachedVertex<Method>*>(static_cast<void*>(slot.vertices))) {}

  template <class Mesh>
  [[nodiscard]] Status begin(const VertexStage<Method, Mesh>& stage, bool) {
    const std::size_t count = slot_.object->mesh().vertex_count();
    if (slot_.held != &use_) {
      forget_vertices(vertices_, count);
      slot_.held = &use_;
    } else if (stage.shading() == kSharedShading) {
      for (std::size_t i = 0; i < count; ++i) vertices_[i].shading = 0;
    }
    return Status::kOk;
  }
  template <class Mesh>
  [[nodiscard]] ARCSPAN_INLINE CachedVertex<Method>& vertex(const VertexStage<Method, Mesh>& stage,
                                                            std::size_t i) {
    CachedVertex<Method>& vertex = vertices_[i];
    if (vertex.outcode == CachedVertex<Method>::kNotTransformed) stage.transform(i, vertex);
    return vertex;
  }
  [[nodiscard]] static constexpr const TriangleRows* rows() { return nullptr; }
  [[nodiscard]] std::span<const CachedVertex<Method>> all() const {
    return {vertices_, slot_.object->mesh().vertex_count()};
  }

  /// The number of the shading of all parts from the 255th on, which shade their vertices anew.
  static constexpr std::uint8_t kSharedShading = 255;
  /// Returns the number of a part's shading (VertexStage).
  [[nodiscard]] static constexpr std::uint8_t shading_of(std::size_t part) {
    return part < kSharedShading - 1 ? static_cast<std::uint8_t>(part + 1) : kSharedShading;
  }

 private:
  SceneSlot& slot_;
  const UseFacts& use_;
  CachedVertex<Method>* vertices_;
};

/// draw_mesh() with the vertices of the part's slot, which exist if `KeepsVertices`.
template <class Used, bool KeepsVertices, class Sink, class Depth>
requires(!IsPosed<Used>) DrawResult
    draw_lit_part(const PartCall<Sink, Depth>& part, const typename Used::Method::Lighting& lighting) {
  using Method = typename Used::Method;
  TriangleDrawer<Method, Used::kFeatures, Sink, Depth> drawer(
      {part.mesh, part.slot.transform, lighting, SlotVertices<Method>::shading_of(part.number)}, part.sink,
      part.depth, part.material.options());
  if constexpr (KeepsVertices) {
    SlotVertices<Method> vertices(part.slot, kUseFacts<Used>);
    drawer.draw(vertices);
  } else {
    NoCache vertices;
    drawer.draw(vertices);
  }
  return drawer.result();
}

/// draw_lit_part() of vertices that a mesh poses.
template <IsPosed Used, bool KeepsVertices, class Sink, class Depth>
DrawResult draw_lit_part(const PartCall<Sink, Depth>& part, const typename Used::Method::Lighting& lighting) {
  using Method = typename Used::Method;
  const PosedPart<Used> mesh(part.material, part.mesh);
  if (!mesh.fits()) return {Status::kInvalidArgument};
  TriangleDrawer<Method, Used::kFeatures, Sink, Depth, PosedPart<Used>> drawer(
      {mesh, part.slot.transform, lighting, SlotVertices<Method>::shading_of(part.number)}, part.sink,
      part.depth, part.material.options());
  if constexpr (KeepsVertices) {
    SlotVertices<Method> vertices(part.slot, kUseFacts<Used>);
    drawer.draw(vertices);
  } else {
    NoCache vertices;
    drawer.draw(vertices);
  }
  return drawer.result();
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

template <class Used, PartVertices Vertices, class Sink, class Depth>
DrawResult draw_part_by(const PartCall<Sink, Depth>& part) {
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
    return draw_lit_part<Drawn, kKeepsVertices>(part, lighting);
  } else if constexpr (FollowsView<Lighting>) {
    auto& lighting = *static_cast<Lighting*>(part.lighting);
    copy_words(material.lighting(), lighting);
    lighting.set_rotation(part.camera * part.slot.object->rotation);
    return draw_lit_part<Drawn, kKeepsVertices>(part, lighting);
  } else {
    return draw_lit_part<Drawn, kKeepsVertices>(part, material.lighting());
  }
}

/// Draws a part by the method of its material, which is listed.
template <PartVertices Vertices, class... Used, class Sink, class Depth>
DrawResult draw_part(MethodList<Used...>, const PartCall<Sink, Depth>& part) {
  if constexpr (sizeof...(Used) == 1) {
    return draw_part_by<Used..., Vertices>(part);
  } else {
    using Function = DrawResult (*)(const PartCall<Sink, Depth>&);
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
