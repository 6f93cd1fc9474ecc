// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/scene.hpp>
#include <arcspan/scene/pick_frame.hpp>

#include <cstdint>

namespace arcspan {

namespace detail {

template <class List>
struct PickList;
/// How triangles of the materials of a SceneMemory are drawn unshaded.
template <class... Used>
struct PickList<MethodList<Used...>> {
  static constexpr PickUse kAll[] = {
      {&kUseFacts<Used>, &draw_unshaded<Used>, DrawsEdges<typename Used::Method>}...};
  static constexpr bool kPoses = (IsPosed<Used> || ...);
};

}  // namespace detail

/// Returns what the scene of the last prepare_scene() shows in the pixel in column x and row y of the
/// picture: the object, its part and the triangle that a draw call with a DepthBuffer leaves there, by the
/// same culling, clipping and order of equal depths. Outside of the picture nothing is found.
///
/// Nothing is shaded, so the time does not depend on materials: textures and operations do not make a pixel
/// transparent, blended surfaces count as if they wrote depths, and where a textured or a clipped triangle of
/// up to 32x32 pixels is at most 10 steps of depth from another surface, or thinner than a pixel, either
/// surface may be picked. Objects whose bounding spheres miss the pixel are skipped. Of the triangles of the
/// others, only those around the pixel are transformed; all of them are if `memory` lists a Posed.
///
/// It needs no picture and no depths. The memory in which draw calls make a material (SceneMemory) holds a
/// byte for each vertex meanwhile; for a mesh with more vertices, triangles take twice as long.
template <SceneMemoryType Memory>
[[nodiscard]] Picked pick(Memory& memory, std::int32_t x, std::int32_t y) {
  if (!ok(memory.status())) return {memory.status()};
  using List = detail::PickList<typename Memory::UseList>;
  if constexpr (List::kPoses) {
    return detail::pick_posed_in(memory.frame(), List::kAll, x, y);
  } else {
    return detail::pick_in(memory.frame(), List::kAll, memory.scratch(), x, y);
  }
}

}  // namespace arcspan
