// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/draw/wireframe.hpp>
#include <arcspan/pixel/gray8.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/posed_material.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan {

/// The result of pick().
struct Picked {
  Status status = Status::kOk;     ///< that of prepare_scene(), or kNotReady before it
  const Object* object = nullptr;  ///< an element of Scene::objects, or null if there is nothing
  std::size_t part = 0;            ///< index of the part of the object
  std::size_t triangle = 0;        ///< index of the triangle in the object's mesh
  std::uint16_t depth = DepthBuffer::kFarthest;  ///< at the pixel's centre
};

namespace detail {

/// A picture of one pixel, which nobody looks at.
struct PickSink {
  using Format = Gray8;
  std::int32_t x;
  std::int32_t y;
  std::uint8_t pixel = 0;

  [[nodiscard]] Rect bounds() const { return {x, y, x + 1, y + 1}; }
  [[nodiscard]] Format::Cursor open(const Span&) { return {&pixel, 0}; }
  [[nodiscard]] static Status close(const Span&) { return Status::kOk; }
};

/// Unlit with the small triangles of another method.
template <std::int32_t SmallSize>
struct PickMethod : Unlit {
  using DrawsSmallTrianglesAs = PickMethod;
  static constexpr std::int32_t kSmallSize = SmallSize;
};

/// The arguments by which pick() draws a triangle.
struct PickCall {
  const SceneSlot& slot;
  const SceneMaterial& material;
  PickSink& sink;
  const DepthBuffer& depth;
};

/// Draws a mesh of one triangle as `Used` does, without its shading.
template <class Used>
[[nodiscard]] Status draw_unshaded(const PickCall& call, const MeshView& triangle) {
  using Method = typename Used::Method;
  constexpr bool kSmall = Used::kFeatures.small_triangles && DrawsSmallTriangles<Method>;
  using Plain = std::conditional_t<DrawsEdges<Method>, Wireframe<>, PickMethod<small_size<Method>()>>;
  constexpr DrawFeatures kFeatures{
      .clips = Used::kFeatures.clips, .planes = false, .small_triangles = kSmall};
  typename Plain::Lighting lighting{};
  if constexpr (DrawsEdges<Method>) lighting.set(prepared<Used>(call.material).lighting().bias);
  return with_vertices<Used>(call.material, triangle, Status::kInvalidArgument, [&](const auto& mesh) {
    return draw_mesh<Plain, kFeatures>(mesh, call.slot.transform, lighting, call.sink, call.depth, NoCache{},
                                       prepared<Used>(call.material).options())
        .status;
  });
}

/// The entry of a Use in the list of a SceneMemory.
struct PickUse {
  const UseFacts* use;
  Status (*draw)(const PickCall&, const MeshView& triangle);
  bool edges;  ///< DrawsEdges
};

/// pick() in a prepared frame. `scratch` is for a byte per vertex of an object.
[[nodiscard]] Picked pick_in(const SceneFrame& frame, std::span<const PickUse> uses,
                             std::span<std::uint8_t> scratch, std::int32_t x, std::int32_t y);
/// pick_in() where objects may be posed: all triangles of an object around the pixel are transformed.
[[nodiscard]] Picked pick_posed_in(const SceneFrame& frame, std::span<const PickUse> uses, std::int32_t x,
                                   std::int32_t y);

}  // namespace detail

}  // namespace arcspan
