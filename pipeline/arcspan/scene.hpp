// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/pixel/background.hpp>
#include <arcspan/scene/camera.hpp>
#include <arcspan/scene/draw_part.hpp>
#include <arcspan/scene/object.hpp>
#include <arcspan/scene/scene_frame.hpp>
#include <arcspan/scene/scene_light.hpp>
#include <arcspan/scene/scene_material.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

template <class List, std::size_t Objects, std::size_t Vertices = 0>
class SceneMemory;

/// The memory of a scene that is being drawn, of the caller's: usually static. `Objects` is the most that are
/// in view at a time. `Vertices` is at least the number of vertices of the largest mesh, or 0: then each
/// triangle transforms its own three vertices. If there is room for the vertices of all objects in view, they
/// are kept from band to band. It needs no initialisation and may be used for any scene.
template <class... Methods, std::size_t Objects, std::size_t Vertices>
class SceneMemory<MethodList<Methods...>, Objects, Vertices> {
 public:
  static_assert(sizeof...(Methods) > 0 && Objects <= 65535);

  /// @cond for draw_mesh() and draw_scene(), not in the reference
  [[nodiscard]] void* lighting() { return lighting_; }
  [[nodiscard]] std::span<unsigned char> scratch() { return {lighting_, kLightingBytes}; }
  [[nodiscard]] detail::SceneFrame frame() {
    return {header_,
            {static_cast<detail::SceneSlot*>(static_cast<void*>(slots_)), Objects},
            order_,
            {vertices_, kVertexBytes * Vertices},
            kFacts};
  }
  /// @endcond

 private:
  static constexpr const detail::UseFacts* kFacts[] = {
      &detail::kUseFacts<typename detail::UseOf<Methods>::Type>...};
  static constexpr std::size_t kVertexBytes = [] {
    std::size_t most = 0;
    for (const detail::UseFacts* const facts : kFacts) {
      if (facts->vertex_bytes > most) most = facts->vertex_bytes;
    }
    return most;
  }();

  template <class... Used>
  static constexpr std::size_t most_lighting_bytes(MethodList<Used...>) {
    std::size_t most = 1;
    for (const std::size_t bytes : {sizeof(typename Used::Method::Lighting)...})
      most = bytes > most ? bytes : most;
    return most;
  }
  static constexpr std::size_t kLightingBytes =
      most_lighting_bytes(MethodList<typename detail::UseOf<Methods>::Type...>{});

  detail::SceneHeader header_;
  std::uint16_t order_[Objects > 0 ? Objects : 1] = {};
  // Bytes, because initialised slots would take flash too.
  alignas(
      detail::SceneSlot) unsigned char slots_[sizeof(detail::SceneSlot) * (Objects > 0 ? Objects : 1)] = {};
  alignas(8) unsigned char lighting_[kLightingBytes] = {};
  alignas(8) unsigned char vertices_[kVertexBytes * Vertices + 1] = {};
};

/// The result of drawing a scene or a band of it.
struct SceneResult {
  Status status = Status::kOk;
  std::uint32_t objects = 0;    ///< objects that may have pixels in the target
  std::uint32_t triangles = 0;  ///< of these objects, as in DrawResult
  std::uint32_t left_out = 0;   ///< as in DrawResult
};

/// Sets up a frame of `scene` in `memory`: the transforms of the objects in view and their order. Once per
/// frame, before draw_prepared_scene(); whatever `scene` refers to must stay until the last band is drawn.
/// Returns kOk, or draws nothing until the next call and returns:
///
///   kNotReady          the camera has not been made
///   kScaleOutOfRange   an object's scale is below 2^-10
///   kIndexOutOfRange   a part of an object has triangles that its mesh does not have
///   kMethodNotListed   a material's method is not in the list of `memory`
///   kTooManyLights     a material's method takes fewer lights than the scene has
///   kTooManyObjects    more objects are in view than `memory` holds
///   kCacheTooSmall     a mesh has more vertices than `memory` holds, which is not 0
///   kUnsupported       there are several lights, one of them coloured, and a material's illumination has not
///                      IlluminationFeatures::coloured_lights
///   kInvalidArgument   a light's strength or colour is outside 0...1, the half distance of a point light is
///                      not above 0, or a part has no material
template <class List, std::size_t Objects, std::size_t Vertices>
[[nodiscard]] Status prepare_scene(const Scene& scene, SceneMemory<List, Objects, Vertices>& memory) {
  return detail::prepare(scene, memory.frame());
}

namespace detail {

/// Leaves what is in the target.
struct KeepTarget {
  template <class Sink, class Depth>
  [[nodiscard]] static constexpr Status clear(Sink&, const Depth&) {
    return Status::kOk;
  }
};

/// Clears depth and pixels.
template <class Background>
struct ClearTarget {
  const Background& background;

  template <class Sink, class Depth>
  [[nodiscard]] constexpr Status clear(Sink& sink, const Depth& depth) const {
    static_assert(Depth::kWrites || !Depth::kTests,
                  "a pass that only tests depths needs those of an earlier one");
    if constexpr (Depth::kTests) depth.clear();
    if constexpr (requires { sink.clear(background); }) {
      sink.clear(background);
      return Status::kOk;
    } else {
      return draw_background(sink, background);
    }
  }
};

template <class Target, class... Methods, std::size_t Objects, std::size_t Vertices, PixelSink Sink,
          DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared(SceneMemory<MethodList<Methods...>, Objects, Vertices>& memory,
                                        Sink& sink, const Depth& depth, const Target& target) {
  constexpr bool kNearestFirst = Depth::kTests && Depth::kWrites;
  const SceneFrame frame = memory.frame();
  SceneResult result{frame.header.camera == nullptr ? Status::kNotReady : frame.header.status};
  if (!ok(result.status)) return result;
  const Viewport& viewport = frame.header.camera->viewport();
  const Rect whole{0, 0, viewport.width, viewport.height};
  const Rect rect = intersection(whole, sink.bounds());
  result.status = check_target(Scissor(viewport, sink.bounds()), sink, depth);
  if (ok(result.status)) result.status = target.clear(sink, depth);
  const std::size_t count = frame.header.in_view;
  for (std::size_t i = 0; i < count && ok(result.status); ++i) {
    SceneSlot& slot = frame.slots[frame.order[kNearestFirst ? i : count - 1 - i]];
    if (rect != whole && is_outside(slot, rect)) continue;
    ++result.objects;
    if (!frame.header.keeps_vertices) slot.held = nullptr;
    const ObjectLights lights = lights_at(frame.header, *slot.object);
    for (std::size_t p = 0; p < slot.object->part_count() && ok(result.status); ++p) {
      const Part part = slot.object->part(p);
      const MeshView mesh = slot.object->mesh().part(part.first, part.count);
      const DrawResult drawn = draw_part<Vertices != 0>(
          MethodList<typename UseOf<Methods>::Type...>{},
          PartCall<Sink, Depth>{slot, mesh, p, *part.material, lights, frame.header.camera->rotation(), sink,
                                depth, memory.lighting()});
      result.status = drawn.status;
      result.triangles += drawn.triangles;
      result.left_out += drawn.left_out;
    }
  }
  return result;
}

}  // namespace detail

/// Draws the scene of the last prepare_scene() into `sink`: the whole picture, or a band of it. Objects whose
/// bounding sphere lies outside of it are skipped. With a depth target that writes, the nearest object is
/// drawn first, which saves pixels. With NoDepth or ReadOnlyDepth the farthest is, so that nearer ones cover
/// it or are blended with it. The nearer object is the one whose bounding sphere has the nearer middle.
/// Returns as status that of prepare_scene(), or:
///
///   kDepthMismatch   `depth` does not cover the common bounds of the picture and the sink
///   kLightChanged    see Use
///   others           as draw_mesh()
template <class... Methods, std::size_t Objects, std::size_t Vertices, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(SceneMemory<MethodList<Methods...>, Objects, Vertices>& memory,
                                              Sink& sink, const Depth& depth) {
  return detail::draw_prepared(memory, sink, depth, detail::KeepTarget{});
}

/// draw_prepared_scene() with all of `sink` and `depth` cleared before, unless it draws nothing. `background`
/// is an Rgb8, a VerticalGradient or a BackgroundPicture. Returns further statuses as draw_background().
template <class Background = Rgb8, class... Methods, std::size_t Objects, std::size_t Vertices,
          PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(SceneMemory<MethodList<Methods...>, Objects, Vertices>& memory,
                                              Sink& sink, const Depth& depth, const Background& background) {
  return detail::draw_prepared(memory, sink, depth, detail::ClearTarget<Background>{background});
}

/// Draws a scene into `sink`: prepare_scene() and draw_prepared_scene(). For bands, call it once per band; to
/// save the preparation, call the two yourself.
template <class... Methods, std::size_t Objects, std::size_t Vertices, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth,
                                     SceneMemory<MethodList<Methods...>, Objects, Vertices>& memory) {
  const Status status = prepare_scene(scene, memory);
  if (!ok(status)) return {status};
  return draw_prepared_scene(memory, sink, depth);
}

/// draw_scene() with all of `sink` and `depth` cleared before, so that neither can be forgotten. `background`
/// is as for draw_prepared_scene().
template <class Background = Rgb8, class... Methods, std::size_t Objects, std::size_t Vertices,
          PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth,
                                     SceneMemory<MethodList<Methods...>, Objects, Vertices>& memory,
                                     const Background& background) {
  const Status status = prepare_scene(scene, memory);
  if (!ok(status)) return {status};
  return draw_prepared_scene(memory, sink, depth, background);
}

}  // namespace arcspan
