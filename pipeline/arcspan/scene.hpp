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
#include <arcspan/scene/scene_memory.hpp>
#include <arcspan/scene/scene_pass.hpp>
#include <arcspan/span/depth_mode.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

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
///   kUnsupported       a light is coloured, and a material's illumination of several lights lacks
///                      IlluminationFeatures::coloured_lights
///   kInvalidArgument   a light's strength or colour is outside 0...1, the half distance of a point light is
///                      not above 0, or a part has no material
///   kBufferTooSmall    `memory` is a view that was given too little
template <SceneMemoryType Memory>
[[nodiscard]] Status prepare_scene(const Scene& scene, Memory& memory) {
  if (!ok(memory.status())) return memory.status();
  return detail::prepare(scene, memory.frame());
}

namespace detail {

/// prepare_scene() for a single call of draw_prepared_scene(), for which rows are not worth finding.
template <SceneMemoryType Memory>
[[nodiscard]] Status prepare_once(const Scene& scene, Memory& memory) {
  if (!ok(memory.status())) return memory.status();
  SceneFrame frame = memory.frame();
  frame.rows = {};
  return prepare(scene, frame);
}

/// Does nothing besides drawing: the base of what draw_prepared() takes as its target.
struct PlainTarget {
  /// Pixels beyond the picture or band whose objects are looked at, too.
  static constexpr std::int32_t kBeyond = 0;
  /// Returns what stands for the rows of an object, which is drawn next.
  template <class Memory>
  [[nodiscard]] static typename Memory::KeptRows begin_object(SceneSlot& slot, bool finds_rows) {
    return typename Memory::KeptRows(slot, finds_rows);
  }
  /// After the object at this place of SceneFrame::order.
  template <class Uses, class Memory, class Sink, class Depth>
  static constexpr void end_object(Memory&, std::size_t, const ObjectLights&, Sink&, const Depth&,
                                   SceneResult&) {}
};

/// Leaves what is in the target.
struct KeepTarget : PlainTarget {
  template <class Sink, class Depth>
  [[nodiscard]] static constexpr Status clear(Sink&, const Depth&) {
    return Status::kOk;
  }
};

/// Clears depth and pixels.
template <class Background>
struct ClearTarget : PlainTarget {
  constexpr explicit ClearTarget(const Background& background) : background_(background) {}

  template <class Sink, class Depth>
  [[nodiscard]] constexpr Status clear(Sink& sink, const Depth& depth) const {
    static_assert(Depth::kWrites || !Depth::kTests,
                  "a pass that only tests depths needs those of an earlier one");
    if constexpr (requires { sink.clear(background_); }) {
      sink.clear(background_);
    } else {
      const Status status = draw_background(sink, background_);
      if (!ok(status)) return status;
    }
    if constexpr (Depth::kTests) depth.clear();
    return Status::kOk;
  }

 private:
  const Background& background_;
};

template <SceneMemoryType Memory>
inline constexpr PartVertices kVerticesIn =
    Memory::kHasVertices ? PartVertices::kInSlot : PartVertices::kNotKept;

/// What draw_pass() draws and where, but for the depth, which a pass over blended parts only reads.
template <class Target, class Memory, class Sink>
struct SceneCall {
  Memory& memory;
  const SceneFrame& frame;
  Sink& sink;
  const Target& target;
  const Rect& whole;    ///< the picture
  const Rect& rect;     ///< of it, what the sink holds
  const Rect& reached;  ///< `rect` and Target::kBeyond pixels around it
};

/// Draws the parts of an object whose materials are for `Uses`.
template <class Uses, class Target, class Memory, class Sink, class Depth>
ARCSPAN_INLINE inline void draw_parts(const SceneCall<Target, Memory, Sink>& call, SceneSlot& slot,
                                      const ObjectLights& lights, const Depth& depth, SceneResult& result) {
  constexpr bool kAllUses = std::is_same_v<Uses, typename Memory::UseList>;
  const Object& object = *slot.object;
  // Finding the rows of triangles pays if the picture has two bands or more.
  auto rows = call.target.template begin_object<Memory>(slot, 2 * call.rect.height() <= call.whole.height());
  if constexpr (!kAllUses) {
    // Rows are found part by part: there are none where a pass leaves parts out.
    if (count_parts(Uses{}, object) != object.part_count()) rows.leave_out();
  }
  for (std::size_t p = 0; p < object.part_count() && ok(result.status); ++p) {
    const Part part = object.part(p);
    if (kAllUses || is_for(Uses{}, *part.material)) {
      const MeshView mesh = object.mesh().part(part.first, part.count);
      rows.begin_part(part.first);
      const DrawResult drawn = draw_part<kVerticesIn<Memory>>(
          Uses{}, PartCall<Sink, Depth, decltype(rows)>{slot, mesh, p, rows, *part.material, lights,
                                                        call.frame.header.camera->rotation(), call.sink,
                                                        depth, call.memory.lighting()});
      result.status = drawn.status;
      result.triangles += drawn.triangles;
      result.left_out += drawn.left_out;
    }
    rows.next_part(part.count);
  }
}

/// Draws what has materials for `Uses`: the nearest object first if that saves pixels.
template <class Uses, class Target, class Memory, class Sink, class Depth>
ARCSPAN_INLINE inline void draw_pass(const SceneCall<Target, Memory, Sink>& call, const Depth& depth,
                                     SceneResult& result) {
  constexpr bool kAllUses = std::is_same_v<Uses, typename Memory::UseList>;
  constexpr bool kNearestFirst = Depth::kTests && Depth::kWrites;
  const SceneFrame& frame = call.frame;
  const std::size_t count = frame.header.in_view;
  for (std::size_t i = 0; i < count && ok(result.status); ++i) {
    const std::size_t place = kNearestFirst ? i : count - 1 - i;
    SceneSlot& slot = frame.entries[frame.order[place]];
    if (call.reached != call.whole && is_outside(slot, call.reached)) continue;
    bool counts = true;  // in the last pass that draws a part of it
    if constexpr (!kAllUses) {
      if (count_parts(Uses{}, *slot.object) == 0) continue;
      counts = !kNearestFirst || count_parts(BlendedUses<typename Memory::UseList>{}, *slot.object) == 0;
    }
    const bool is_within = Target::kBeyond == 0 || call.rect == call.whole || !is_outside(slot, call.rect);
    if (counts && is_within) ++result.objects;
    if (!frame.header.keeps_vertices) slot.held = nullptr;
    const ObjectLights lights = lights_at(frame.header, *slot.object);
    draw_parts<Uses>(call, slot, lights, depth, result);
    call.target.template end_object<Uses>(call.memory, place, lights, call.sink, depth, result);
  }
}

template <class Target, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared(Memory& memory, Sink& sink, const Depth& depth,
                                        const Target& target) {
  using Listed = typename Memory::UseList;
  if (!ok(memory.status())) return {memory.status()};
  const SceneFrame frame = memory.frame();
  SceneResult result{frame.header.camera == nullptr ? Status::kNotReady : frame.header.status};
  if (!ok(result.status)) return result;
  const Viewport& viewport = frame.header.camera->viewport();
  const Rect whole{0, 0, viewport.width, viewport.height};
  const Rect rect = intersection(whole, sink.bounds());
  constexpr std::int32_t kBeyond = Target::kBeyond;
  const Rect beyond{rect.left - kBeyond, rect.top - kBeyond, rect.right + kBeyond, rect.bottom + kBeyond};
  const Rect reached = kBeyond == 0 || rect.empty() ? rect : intersection(whole, beyond);
  result.status = check_target(Scissor(viewport, sink.bounds()), sink, depth);
  if (ok(result.status)) result.status = target.clear(sink, depth);
  const SceneCall<Target, Memory, Sink> call{memory, frame, sink, target, whole, rect, reached};
  if constexpr (Depth::kTests && Depth::kWrites && kHasBlended<Listed>) {
    if constexpr (!std::is_same_v<OpaqueUses<Listed>, MethodList<>>)
      draw_pass<OpaqueUses<Listed>>(call, depth, result);
    draw_pass<BlendedUses<Listed>>(call, read_only(depth), result);
  } else {
    draw_pass<Listed>(call, depth, result);
  }
  return result;
}

}  // namespace detail

/// Draws the scene of the last prepare_scene() into `sink`: the whole picture, or a band of it. Objects whose
/// bounding sphere lies outside of it are skipped. With a depth target that writes, the nearest object is
/// drawn first, which saves pixels; then the parts that are blended with what is there (Opacity), the
/// farthest object first, which write no depths. With NoDepth or ReadOnlyDepth the farthest is first, so that
/// nearer ones cover it or are blended with it. The nearer object is the one whose bounding sphere has the
/// nearer middle.
/// Returns as status that of prepare_scene(), or:
///
///   kDepthMismatch     `depth` does not cover the common bounds of the picture and the sink
///   kLightChanged      see Use
///   kInvalidArgument   the mesh of a PosedMaterial has another number of vertices than that of its object
///   others             as draw_mesh()
template <SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth) {
  return detail::draw_prepared(memory, sink, depth, detail::KeepTarget{});
}

/// draw_prepared_scene() with all of `sink` and `depth` cleared before, unless it draws nothing. `background`
/// is an Rgb8, a VerticalGradient or a BackgroundPicture. Returns further statuses as draw_background().
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_prepared_scene(Memory& memory, Sink& sink, const Depth& depth,
                                              const Background& background) {
  return detail::draw_prepared(memory, sink, depth, detail::ClearTarget<Background>(background));
}

/// Draws a scene into `sink`: prepare_scene() and draw_prepared_scene(). For bands, call it once per band,
/// or, which is faster, the two yourself: then vertices and rows are kept from band to band.
template <SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory) {
  const Status status = detail::prepare_once(scene, memory);
  if (!ok(status)) return {status};
  return draw_prepared_scene(memory, sink, depth);
}

/// draw_scene() with all of `sink` and `depth` cleared before, so that neither can be forgotten. `background`
/// is as for draw_prepared_scene().
template <class Background = Rgb8, SceneMemoryType Memory, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] SceneResult draw_scene(const Scene& scene, Sink& sink, const Depth& depth, Memory& memory,
                                     const Background& background) {
  const Status status = detail::prepare_once(scene, memory);
  if (!ok(status)) return {status};
  return draw_prepared_scene(memory, sink, depth, background);
}

}  // namespace arcspan
