// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/triangle_rows.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/scene/camera.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/scene_light.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// A camera, lights and objects, which draw_scene() draws. All three belong to the caller, and must stay
/// until the last band is drawn.
struct Scene {
  constexpr Scene(const Camera& seen_by, const LightList& lit_by, std::span<const Object> standing)
      : camera(seen_by), lights(lit_by), objects(standing) {}
  Scene(const Camera&&, const LightList&, std::span<const Object>) = delete;

  const Camera& camera;
  LightList lights;
  std::span<const Object> objects;
};

namespace detail {

/// An object's bounding sphere in clip space: its middle, and upper bounds of the lengths of its radius.
struct ClipSphere {
  ClipPosition middle;
  std::int32_t radius_across;  ///< in x and y
  std::int32_t radius_ahead;   ///< in w
};

[[nodiscard]] inline ClipSphere clip_sphere(const ClipTransform& transform, const BoundingSphere& sphere) {
  return {transform(sphere.middle), transform.length_across(sphere.radius),
          transform.length_ahead(sphere.radius)};
}

/// An object in view.
struct SceneSlot {
  ClipTransform transform;
  ClipSphere sphere;
  const Object* object;
  unsigned char* vertices;        ///< memory for CachedVertex, or null
  const UseFacts* held;           ///< the use that has written the vertices, or null
  TriangleRows* rows;             ///< memory for the rows of the triangles of all parts, in turn, or null
  std::size_t vertex_bytes;       ///< that the vertices take at most, 0 without memory for any
  std::int32_t distance;          ///< Camera::distance_to() the sphere's middle, 13 fraction bits
  std::uint16_t end_of_curves;    ///< set by find_outlines() with curves
  std::uint16_t parts_with_rows;  ///< from the first one on; parts are drawn in turn, or drawing ends
};

/// The part of a SceneMemory that belongs to the whole scene. All is zero at first, so that static memory
/// takes no flash.
struct SceneHeader {
  LightList lights{{}, {}};
  const Camera* camera = nullptr;  ///< null before the first frame
  std::uint16_t in_view = 0;       ///< slots in use
  bool keeps_vertices = false;     ///< each slot has vertices of its own; else all have the same
  Status status = Status::kOk;
};

/// The vertices of each slot begin at a multiple of it in a SceneMemory.
inline constexpr std::size_t kVertexAlignment = 8;

/// A view of a SceneMemory.
struct SceneFrame {
  SceneHeader& header;
  std::span<SceneSlot> entries;
  std::span<std::uint16_t> order;  ///< indices of slots, the nearest object first
  std::span<unsigned char> vertices;
  std::span<TriangleRows> rows;
  bool has_vertices;  ///< otherwise each triangle transforms its own
  std::span<const UseFacts* const> uses;
};

/// Checks the scene, and sets up the objects that are in view of the camera. Returns the status of
/// prepare_scene().
[[nodiscard]] Status prepare(const Scene& scene, const SceneFrame& frame);

/// True if the object of `slot` has no pixel in `rect`, which is within the viewport.
[[nodiscard]] bool is_outside(const SceneSlot& slot, const Rect& rect);

/// The lights of a scene and the direction to the eye in the space of an object.
[[nodiscard]] ObjectLights lights_at(const SceneHeader& header, const Object& object);

}  // namespace detail

}  // namespace arcspan
