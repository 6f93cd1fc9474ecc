// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_sides.hpp>
#include <arcspan/draw/vertex_stage.hpp>
#include <arcspan/mesh/mesh_neighbours.hpp>
#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/scene/draw_part.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/posed_material.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/scene/scene_memory.hpp>
#include <arcspan/scene/slot_vertices.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <span>

/// The sides of the triangles of a scene's objects: found before they are drawn, for pictures in bands, or
/// written down while they are.
namespace arcspan::detail {

/// A part of an object whose sides are to be found. `KeptRows` is PartRows or NoRows.
template <class KeptRows>
struct SidesCall {
  SceneSlot& slot;
  const MeshView& mesh;  ///< of the part
  const KeptRows& rows;
  const SceneMaterial& material;
  std::span<TriangleSide> sides;
};

/// Finds the sides of a part whose material is for `Used`.
template <class Used, bool KeepsVertices, class KeptRows>
[[nodiscard]] Status find_part_sides(const SidesCall<KeptRows>& call) {
  const auto find_with = [&](const auto& mesh, auto&& vertices) {
    const auto& material = prepared<Used>(call.material);
    return find_sides<typename Used::Method>(mesh, call.slot.transform, material.lighting(), vertices,
                                             call.sides, material.options());
  };
  if constexpr (KeepsVertices) {
    SlotVertices<typename Used::Method, KeptRows> vertices(call.slot, kUseFacts<Used>, call.rows);
    return with_vertices<Used>(call.material, call.mesh, Status::kInvalidArgument,
                               [&](const auto& mesh) { return find_with(mesh, vertices); });
  } else if constexpr (IsPosed<Used>) {
    return Status::kUnsupported;  // check_outlined() has refused it
  } else {
    return find_with(call.mesh, UncachedPart(call.rows));
  }
}

/// Stands for PartRows where a call draws and finds outlines: writes down the sides of an object's triangles
/// while its parts are drawn.
class PartSides : public NoRows {
 public:
  /// `sides` has an element for each triangle of the object. Null: the object is drawn, its sides are not
  /// kept.
  constexpr explicit PartSides(TriangleSide* sides) : sides_(sides), of_part_(sides) {}

  constexpr void begin_part(std::size_t first) {
    if (sides_ != nullptr) of_part_ = sides_ + first;
  }
  /// Hides a part again that overlaps one drawn before.
  template <class Method, class Mesh, class Source>
  void find(const VertexStage<Method, Mesh>& stage, bool, Source&) const {
    if (sides_ != nullptr) (void)hide_all(stage.mesh(), {of_part_, stage.mesh().triangle_count()});
  }
  ARCSPAN_INLINE constexpr void note_side(std::size_t i, TriangleSide side) const {
    if (sides_ != nullptr) of_part_[i] = side;
  }

 private:
  TriangleSide* sides_;
  TriangleSide* of_part_;
};

/// Whether a mesh poses the vertices of a material.
template <class... Used>
[[nodiscard]] bool is_posed(MethodList<Used...>, const SceneMaterial& material) {
  return ((IsPosed<Used> && material.use() == &kUseFacts<Used>) || ...);
}

/// Whether a mesh poses the vertices of a part of the object.
template <class... Used>
[[nodiscard]] bool is_posed(MethodList<Used...> list, const Object& object) {
  for (std::size_t i = 0; i < object.part_count(); ++i)
    if (is_posed(list, *object.part(i).material)) return true;
  return false;
}

/// Whether the sides of an object in view can be found: kOk, or a status of find_outlines().
template <SceneMemoryType Memory>
[[nodiscard]] Status check_outlined(const Object& object, const MeshNeighbours* neighbours,
                                    std::span<const TriangleSide> sides) {
  if (neighbours == nullptr) return Status::kUnsupported;
  if (sides.size() < object.mesh().triangle_count()) return Status::kBufferTooSmall;
  if (!is_posed(typename Memory::UseList{}, object)) return Status::kOk;
  // The places of posed vertices are known only from the slot, which must keep those of all parts.
  if (!Memory::kHasVertices) return Status::kUnsupported;
  for (std::size_t i = 1; i < object.part_count(); ++i)
    if (object.part(i).material->use() != object.part(0).material->use()) return Status::kUnsupported;
  return Status::kOk;
}

/// The places of an object's vertices: those in its slot, if there are some.
template <class List>
[[nodiscard]] VertexPositions positions_of(List list, const SceneSlot& slot) {
  VertexPositions positions(slot.transform);
  with_use(list, slot.held, [&]<class U>() {
    using Vertex = CachedVertex<typename U::Method>;
    const auto* const vertices = static_cast<const Vertex*>(static_cast<const void*>(slot.vertices));
    positions = VertexPositions(slot.transform, std::span(vertices, slot.object->mesh().vertex_count()));
  });
  return positions;
}

}  // namespace arcspan::detail
