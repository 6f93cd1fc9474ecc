// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene.hpp>
#include <arcspan/scene/screen_extent.hpp>

#include <cstddef>

namespace arcspan {

namespace detail {

/// Returns the drawn rectangle of part `number` of the object of a slot, whose material is for `Used`: of a
/// MeshView or PosedPart.
template <class Used, bool KeepsVertices, DrawableMesh Mesh>
[[nodiscard]] Rect drawn_rect_of_part(SceneSlot& slot, const Mesh& mesh, std::size_t number,
                                      const SceneMaterial& material) {
  using Method = typename Used::Method;
  const ExtentOptions options{prepared<Used>(material).options().two_sided, Used::kFeatures.clips,
                              DrawsEdges<Method>};
  VertexStage<Method, Mesh> stage(mesh, slot.transform, prepared<Used>(material).lighting(),
                                  shading_of(number));
  if constexpr (Used::kFeatures.planes && !IsPosed<Used>) {
    if (!options.two_sided) stage.find_back_faces();
  }
  ScreenExtent extent;
  const auto include = [&](auto& vertices) {
    if constexpr (IsPosed<Used>) {
      include_triangles(stage, vertices, options, AllTriangles{}, extent);
    } else {
      include_triangles(stage, vertices, options, extent);
    }
  };
  if constexpr (KeepsVertices) {
    SlotVertices<Method> vertices(slot, kUseFacts<Used>);
    if (!ok(vertices.begin(stage, options.two_sided))) return {};
    include(vertices);
  } else {
    NoCache vertices;
    include(vertices);
  }
  return pixels_of(extent, options.edges, slot.transform.viewport());
}

/// Returns the drawn rectangle of the object of a slot, whose materials are listed.
template <bool KeepsVertices, class List>
[[nodiscard]] Rect drawn_rect_of(List list, const SceneHeader& header, SceneSlot& slot) {
  if (!header.keeps_vertices) slot.held = nullptr;
  Rect rect{};
  for (std::size_t number = 0; number < slot.object->part_count(); ++number) {
    const Part part = slot.object->part(number);
    const MeshView mesh = slot.object->mesh().part(part.first, part.count);
    with_use(list, part.material->use(), [&]<class U>() {
      const auto rect_of = [&](const auto& drawn) {
        return drawn_rect_of_part<U, KeepsVertices>(slot, drawn, number, *part.material);
      };
      rect = bounding_rect(rect, with_vertices<U>(*part.material, mesh, Rect{}, rect_of));
    });
  }
  return rect;
}

}  // namespace detail

/// Returns the rectangle of the picture that the scene of the last prepare_scene() draws into: every pixel of
/// draw_prepared_scene() lies in it. It is the smallest rectangle of pixels around the places on the screen
/// of the vertices of all drawn triangles, after clipping. Triangles that are culled or out of view are not
/// included, nor are invisible objects; triangles behind others and transparent pixels are. Rect{} if nothing
/// is drawn, or if prepare_scene() did not return kOk. Curves, smooth outlines and ink reach farther:
/// OutlineList::changed_rect().
///
/// For the part of a picture that has to be drawn again, or sent. With room for the vertices of all objects
/// in view (SceneMemory), the vertices are kept, and drawing does not transform them again.
template <SceneMemoryType Memory>
[[nodiscard]] Rect drawn_rect(Memory& memory) {
  if (!ok(memory.status())) return {};
  const detail::SceneFrame frame = memory.frame();
  Rect rect{};
  for (detail::SceneSlot& slot : frame.entries.first(frame.header.in_view)) {
    rect = bounding_rect(
        rect, detail::drawn_rect_of<Memory::kHasVertices>(typename Memory::UseList{}, frame.header, slot));
  }
  return rect;
}

/// Returns the rectangle of one object, an element of Scene::objects, as above. Rect{} if it is not in view.
template <SceneMemoryType Memory>
[[nodiscard]] Rect drawn_rect(Memory& memory, const Object& object) {
  if (!ok(memory.status())) return {};
  const detail::SceneFrame frame = memory.frame();
  for (detail::SceneSlot& slot : frame.entries.first(frame.header.in_view)) {
    if (slot.object != &object) continue;
    return detail::drawn_rect_of<Memory::kHasVertices>(typename Memory::UseList{}, frame.header, slot);
  }
  return {};
}

}  // namespace arcspan
