// SPDX-License-Identifier: MIT
#include <arcspan/drawn_rect.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/scene.hpp>

#include <arcspan_c/memory.hpp>
#include <arcspan_c/scene.hpp>
#include <arcspan_c/view.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

using namespace arcspan;

namespace {

using c::world_point;
using Memory = SceneMemoryView<c::CompiledMethods>;

[[nodiscard]] Lens lens_of(const arcspan_lens& lens) {
  const auto nearest = WorldLength::from_raw(lens.nearest);
  const auto farthest = WorldLength::from_raw(lens.farthest);
  if (lens.angle == 0) return Lens::orthographic(WorldLength::from_raw(lens.extent), nearest, farthest);
  return Lens::field_of_view(Turn{lens.angle}, nearest, farthest);
}

[[nodiscard]] c::DrawFunction draw_function(arcspan_format format) {
  switch (format) {
#if ARCSPAN_C_RGB565
    case ARCSPAN_RGB565:
      return c::draw_rgb565;
#endif
#if ARCSPAN_C_RGB565_SWAPPED
    case ARCSPAN_RGB565_SWAPPED:
      return c::draw_rgb565_swapped;
#endif
#if ARCSPAN_C_RGB888
    case ARCSPAN_RGB888:
      return c::draw_rgb888;
#endif
#if ARCSPAN_C_BGR888
    case ARCSPAN_BGR888:
      return c::draw_bgr888;
#endif
#if ARCSPAN_C_XRGB8888
    case ARCSPAN_XRGB8888:
      return c::draw_xrgb8888;
#endif
#if ARCSPAN_C_ARGB8888
    case ARCSPAN_ARGB8888:
      return c::draw_argb8888;
#endif
#if ARCSPAN_C_GRAY8
    case ARCSPAN_GRAY8:
      return c::draw_gray8;
#endif
#if ARCSPAN_C_GRAY4
    case ARCSPAN_GRAY4:
      return c::draw_gray4;
#endif
#if ARCSPAN_C_MONO
    case ARCSPAN_MONO:
      return c::draw_mono;
#endif
    default:
      return nullptr;
  }
}

/// False if pixels or depths of more than no size are at NULL, or if depths are at an odd address.
[[nodiscard]] bool has_addresses(const arcspan_target& target) {
  const bool is_there =
      (target.pixels != nullptr || target.bytes == 0) && (target.depth != nullptr || target.depth_words == 0);
  return is_there && reinterpret_cast<std::uintptr_t>(target.depth) % alignof(std::uint16_t) == 0;
}

[[nodiscard]] SceneLimits limits_of(const arcspan_view_limits& limits) {
  return {limits.objects, limits.vertices, limits.triangles};
}

}  // namespace

arcspan_view_limits arcspan_limits_of(const arcspan_scene* scene, int keeps_vertices) {
  std::uint64_t largest = 0;
  std::uint64_t all = 0;
  std::uint64_t triangles = 0;
  for (const Object& object : std::span(scene->objects, scene->object_count)) {
    const std::size_t vertices = object.mesh().vertex_count();
    if (vertices > largest) largest = vertices;
    all += vertices;
    triangles += object.mesh().triangle_count();
  }
  const auto limited = [](std::uint64_t n) {
    return static_cast<std::uint32_t>(n < UINT32_MAX ? n : UINT32_MAX);
  };
  if (keeps_vertices == 0) return {scene->object_count, limited(largest), 0};
  return {scene->object_count, limited(all), limited(triangles)};
}

size_t arcspan_view_bytes(const arcspan_view_limits* limits) {
  c::MemoryParts parts;
  (void)parts.take<arcspan_view>();
  (void)parts.take(Memory::bytes(limits_of(*limits)), 1);
  return parts.bytes();
}

arcspan_status arcspan_view_make(void* memory, size_t bytes, const arcspan_view_limits* limits,
                                 arcspan_scene* scene, arcspan_view** view) {
  const std::size_t wanted = arcspan_view_bytes(limits);
  if (memory == nullptr || bytes < wanted || wanted == SIZE_MAX) return ARCSPAN_BUFFER_TOO_SMALL;
  c::MemoryParts parts(memory);
  arcspan_view* const at = parts.take<arcspan_view>();
  const SceneLimits of_memory = limits_of(*limits);
  const std::size_t memory_bytes = Memory::bytes(of_memory);
  auto* const rest = static_cast<std::byte*>(parts.take(memory_bytes, 1));
  *view = new (at) arcspan_view{*scene, Camera(), Memory({rest, memory_bytes}, of_memory), Status::kNotReady};
  return ARCSPAN_OK;
}

arcspan_status arcspan_set_camera(arcspan_view* view, const arcspan_lens* lens, arcspan_point eye,
                                  arcspan_point target, arcspan_point up) {
  LookAt look{world_point(eye), world_point(target)};
  if (up.x != 0 || up.y != 0 || up.z != 0) look.up = normalised(up.x, up.y, up.z);
  const Viewport viewport{lens->width, lens->height};
  return static_cast<arcspan_status>(Camera::make(look, lens_of(*lens), viewport, view->camera));
}

arcspan_quaternion arcspan_dragged(const arcspan_view* view, arcspan_quaternion rotation, int32_t dx,
                                   int32_t dy) {
  const Viewport& viewport = view->camera.viewport();
  const std::int32_t diameter = viewport.width < viewport.height ? viewport.width : viewport.height;
  if (diameter == 0) return rotation;
  constexpr std::int32_t kMost = 4096;
  const auto limited = [](std::int32_t d) { return d < -kMost ? -kMost : d > kMost ? kMost : d; };
  const std::int64_t right = limited(dx);
  const std::int64_t down = limited(dy);
  // The axis is at a right angle to the drag, on the screen. 17 fraction bits leave room for 4096 pixels.
  const auto& rows = view->camera.rotation().m;
  const auto along = [&](std::size_t i) {
    return static_cast<std::int32_t>((down * rows[0][i].raw() + right * rows[1][i].raw()) >> 13);
  };
  return arcspan_multiply({diameter << 17, along(0), along(1), along(2)}, rotation);
}

#if ARCSPAN_C_OUTLINES

namespace {

struct OutlineParts {
  TriangleSide* sides;
  OutlineEdge* edges;
  std::byte* gaps;
#if ARCSPAN_C_CURVED_OUTLINES
  ObjectPosition* curve_positions;
  PackedNormal* curve_normals;
  std::uint16_t* curve_indices;
#endif
};

#if ARCSPAN_C_CURVED_OUTLINES
/// The vertices of all curves.
[[nodiscard]] std::size_t curve_vertices(const arcspan_outline_limits& limits) {
  constexpr std::uint32_t kMost = MeshView::kMaxVertices / 3;
  return 3 * (limits.curves < kMost ? limits.curves : kMost);
}
#endif

[[nodiscard]] OutlineParts take_parts(c::MemoryParts& memory, const arcspan_outline_limits& limits) {
  OutlineParts parts{};
  parts.sides = memory.take<TriangleSide>(limits.triangles);
  parts.edges = memory.take<OutlineEdge>(limits.edges);
  parts.gaps = static_cast<std::byte*>(memory.take(c::kGapBytes, limits.gaps));
#if ARCSPAN_C_CURVED_OUTLINES
  const std::size_t of_curves = curve_vertices(limits);
  parts.curve_positions = memory.take<ObjectPosition>(of_curves);
  parts.curve_normals = memory.take<PackedNormal>(of_curves);
  parts.curve_indices = memory.take<std::uint16_t>(of_curves);
#endif
  return parts;
}

void find_outlines_of(arcspan_view& view) {
  const arcspan_scene& scene = view.scene;
#if ARCSPAN_C_CURVED_OUTLINES
  if (view.outlines.is_curved) {
    SceneOutlines<Rgb565, CurvedOutlines> curved{{scene.outlined, scene.object_count},
                                                 view.outlines.sides,
                                                 view.outlines.edges,
                                                 {},
                                                 view.outlines.curves};
    view.outlines.status = find_outlines(view.memory, curved);
    view.outlines.edges = curved.edges;
    view.outlines.curves = curved.curves;
    return;
  }
#endif
  SceneOutlines<Rgb565> outlines{
      {scene.outlined, scene.object_count}, view.outlines.sides, view.outlines.edges, {}};
  view.outlines.status = find_outlines(view.memory, outlines);
  view.outlines.edges = outlines.edges;
}

[[nodiscard]] std::uint8_t ink_width([[maybe_unused]] const c::ViewOutlines& outlines) {
#if ARCSPAN_C_INK
  return outlines.ink.width;
#else
  return 0;
#endif
}

}  // namespace

size_t arcspan_outline_bytes(const arcspan_outline_limits* limits) {
  c::MemoryParts parts;
  (void)take_parts(parts, *limits);
  return parts.bytes();
}

arcspan_status arcspan_smooth_outlines(arcspan_view* view, void* memory, size_t bytes,
                                       const arcspan_outline_limits* limits) {
  if (memory == nullptr) {
    view->outlines = {};
    return ARCSPAN_OK;
  }
  if (limits->triangles == 0) return ARCSPAN_INVALID_ARGUMENT;  // without sides outlines are off
  const std::size_t wanted = arcspan_outline_bytes(limits);
  if (bytes < wanted || wanted == SIZE_MAX) return ARCSPAN_BUFFER_TOO_SMALL;
  c::MemoryParts all(memory);
  const OutlineParts parts = take_parts(all, *limits);
  view->outlines.sides = {parts.sides, limits->triangles};
  view->outlines.edges = OutlineList({parts.edges, limits->edges});
  view->outlines.gaps = {parts.gaps, c::kGapBytes * limits->gaps};
  view->outlines.status = Status::kOk;
#if ARCSPAN_C_CURVED_OUTLINES
  const std::size_t of_curves = curve_vertices(*limits);
  view->outlines.is_curved = of_curves != 0;
  view->outlines.curves = CurvedOutlines({parts.curve_positions, of_curves}, {parts.curve_normals, of_curves},
                                         {parts.curve_indices, of_curves});
#endif
  return ARCSPAN_OK;
}

#else

size_t arcspan_outline_bytes(const arcspan_outline_limits*) { return 0; }

arcspan_status arcspan_smooth_outlines(arcspan_view*, void*, size_t, const arcspan_outline_limits*) {
  return ARCSPAN_UNSUPPORTED;
}

#endif

arcspan_status arcspan_ink_outlines([[maybe_unused]] arcspan_view* view,
                                    [[maybe_unused]] const arcspan_ink* ink) {
#if ARCSPAN_C_INK
  if (ink == nullptr) {
    view->outlines.ink.width = 0;
    return ARCSPAN_OK;
  }
  if (view->outlines.sides.empty()) return ARCSPAN_NOT_READY;
  if (ink->width < 1 || ink->width > OutlineInk::kWidest) return ARCSPAN_INVALID_ARGUMENT;
  view->outlines.ink = {{ink->colour.r, ink->colour.g, ink->colour.b}, ink->width, ink->creases != 0};
  return ARCSPAN_OK;
#else
  return ARCSPAN_UNSUPPORTED;
#endif
}

arcspan_status arcspan_prepare(arcspan_view* view) {
  const arcspan_scene& scene = view->scene;
  const std::span<const Object> objects(scene.objects, scene.object_count);
  view->status = prepare_scene({view->camera, {scene.light_list().lights}, objects}, view->memory);
#if ARCSPAN_C_OUTLINES
  if (ok(view->status) && !view->outlines.sides.empty()) find_outlines_of(*view);
#endif
  return static_cast<arcspan_status>(view->status);
}

arcspan_rect arcspan_drawn_rect(arcspan_view* view) {
  Rect rect = ok(view->status) ? drawn_rect(view->memory) : Rect{};
#if ARCSPAN_C_OUTLINES
  const c::ViewOutlines& outlines = view->outlines;
  if (ok(view->status)) rect = bounding_rect(rect, outlines.edges.changed_rect(ink_width(outlines)));
#endif
  return {rect.left, rect.top, rect.right, rect.bottom};
}

arcspan_status arcspan_draw(arcspan_view* view, const arcspan_target* target) {
  const c::DrawFunction draw = draw_function(target->format);
  if (draw == nullptr) return ARCSPAN_UNSUPPORTED;
  if (!has_addresses(*target)) return ARCSPAN_INVALID_ARGUMENT;
  return static_cast<arcspan_status>(draw(*view, *target));
}

size_t arcspan_depth_words(arcspan_rect held) {
  const Rect rect = c::rect_of(held);
  constexpr std::int32_t kMost = 32767;
  const bool is_inside = rect.left >= 0 && rect.top >= 0 && rect.right <= kMost && rect.bottom <= kMost;
  if (!is_inside || rect.empty()) return 0;
  const std::uint64_t words =
      std::uint64_t{static_cast<std::uint32_t>(rect.width())} * static_cast<std::uint32_t>(rect.height());
  return words < SIZE_MAX ? static_cast<std::size_t>(words) : SIZE_MAX;
}
