// SPDX-License-Identifier: MIT
#include <arcspan/checked.hpp>
#include <arcspan/scene/scene_frame.hpp>

#include <tuple>

namespace arcspan::detail {

namespace {

/// An upper bound of sqrt(a^2 + b^2) for a, b >= 0, at most 12 % too large: the larger plus half the smaller.
std::int64_t hypotenuse(std::int64_t a, std::int64_t b) {
  return a > b ? a + (b >> 1) + 1 : b + (a >> 1) + 1;
}

/// The coordinates of a sphere along one axis of the picture, in clip space.
struct Extent {
  std::int64_t at;
  std::int64_t radius;
};

/// True if a sphere lies wholly on the side `sign` (-1 or 1) of an edge of a rectangle: a plane through the
/// eye. `edge` is its distance from the middle of the picture in half pixels.
bool is_beyond(const ClipSphere& sphere, const Extent& extent, std::int32_t edge, int sign) {
  // Clip coordinates and those of clipped vertices are rounded by less than this.
  constexpr std::int64_t kRounding = 32;
  const std::int64_t slope = edge < 0 ? -std::int64_t{edge} : edge;
  const std::int64_t distance = sign * (2 * kGuardBand * extent.at - edge * std::int64_t{sphere.middle.w});
  const std::int64_t reach = hypotenuse(2 * kGuardBand * extent.radius, slope * sphere.radius_ahead);
  return distance > reach + kRounding * (2 * kGuardBand + slope);
}

/// True if a sphere lies wholly outside of `begin` ... `end`, columns or rows of a picture of `size` pixels.
/// The ends of lines snap to the nearest sixteenth of a pixel, so `begin` has half a pixel to spare.
bool is_outside_range(const ClipSphere& sphere, const Extent& extent, std::int32_t size, std::int32_t begin,
                      std::int32_t end) {
  return is_beyond(sphere, extent, 2 * begin - size - 1, -1) || is_beyond(sphere, extent, 2 * end - size, 1);
}

[[nodiscard]] bool all_grey(const LightList& lights) {
  for (const SceneLight& light : lights.lights) {
    if (!is_grey(light.colour())) return false;
  }
  return true;
}

/// Checks the material of a part.
[[nodiscard]] Status check_material(const SceneMaterial& material, const LightList& lights,
                                    const SceneFrame& frame) {
  const UseFacts* const use = material.use();
  bool listed = false;
  for (const UseFacts* const one : frame.uses) listed = listed || one == use;
  if (!listed) return Status::kMethodNotListed;
  if (use->lights != 0 && lights.lights.size() > use->lights) return Status::kTooManyLights;
  if (use->needs_grey_lights && !all_grey(lights)) return Status::kUnsupported;
  return Status::kOk;
}

/// Checks an object and returns in `vertex_bytes` the size of its largest cached vertex.
[[nodiscard]] Status check_object(const Object& object, const LightList& lights, const SceneFrame& frame,
                                  std::size_t& vertex_bytes) {
  if (object.scale < Camera::kLeastScale) return Status::kScaleOutOfRange;
  const std::size_t triangles = object.mesh().triangle_count();
  vertex_bytes = 0;
  for (std::size_t i = 0; i < object.part_count(); ++i) {
    const Part part = object.part(i);
    if (part.first > triangles || part.count > triangles - part.first) return Status::kIndexOutOfRange;
    if (part.material == nullptr) return Status::kInvalidArgument;
    const Status status = check_material(*part.material, lights, frame);
    if (!ok(status)) return status;
    const std::size_t bytes = part.material->use()->vertex_bytes;
    if (bytes > vertex_bytes) vertex_bytes = bytes;
  }
  return Status::kOk;
}

/// Inserts the last slot into the order, behind those that are as near.
void insert_into_order(const SceneFrame& frame, std::size_t last) {
  std::size_t i = last;
  for (; i > 0 && frame.entries[frame.order[i - 1]].distance > frame.entries[last].distance; --i) {
    frame.order[i] = frame.order[i - 1];
  }
  frame.order[i] = static_cast<std::uint16_t>(last);
}

/// The distance of the middle of an object's sphere, for SceneSlot. That of the origin is exact, so that
/// objects in the same place have the same, whatever their scales.
[[nodiscard]] std::int32_t distance_of(const Object& object, const Camera& camera, const SceneSlot& slot) {
  const std::int64_t from_origin = std::int64_t{slot.sphere.middle.w} - slot.transform.offset(2);
  const std::int64_t scaled = from_origin * object.scale.raw();
  const int shift = slot.transform.w_bits() + 15;  // 32768 object units are the scale
  const std::int64_t more =
      shift >= 0 ? scaled >> shift : static_cast<std::int64_t>(static_cast<std::uint64_t>(scaled) << -shift);
  return static_cast<std::int32_t>((camera.distance_to(object.position) + more) >> 3);
}

/// Sets up a slot for an object. Returns false if the object is not in view.
[[nodiscard]] bool set_up(const Object& object, const Camera& camera, SceneSlot& slot) {
  ARCSPAN_CHECK(object.sphere().radius != 0 || bounding_sphere(object.mesh()).radius == 0,
                "scene: the bounding sphere of an object is a point: it was made before its mesh");
  if (!camera.place(object.position, object.rotation, object.scale, slot.transform)) return false;
  slot.object = &object;
  slot.sphere = clip_sphere(slot.transform, object.sphere());
  slot.distance = distance_of(object, camera, slot);
  const Viewport& viewport = camera.viewport();
  return !is_outside(slot, {0, 0, viewport.width, viewport.height});
}

/// True if an object for which there is no slot is in view.
[[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD bool is_in_view(const Object& object, const Camera& camera) {
  SceneSlot spare;
  return set_up(object, camera, spare);
}

/// Adds an object to the frame if it is in view.
[[nodiscard]] Status add_object(const Object& object, const Scene& scene, const SceneFrame& frame) {
  std::size_t vertex_bytes = 0;
  const Status status = check_object(object, scene.lights, frame, vertex_bytes);
  if (!ok(status)) return status;
  const std::size_t vertices = frame.has_vertices ? object.mesh().vertex_count() : 0;
  if (vertices != 0 && vertex_bytes > frame.vertices.size() / vertices) return Status::kCacheTooSmall;
  const std::size_t last = frame.header.in_view;
  if (last >= frame.entries.size()) {
    return is_in_view(object, scene.camera) ? Status::kTooManyObjects : Status::kOk;
  }
  if (set_up(object, scene.camera, frame.entries[last])) {
    frame.entries[last].vertex_bytes = vertex_bytes * vertices;
    ++frame.header.in_view;
    insert_into_order(frame, last);
  }
  return Status::kOk;
}

/// Gives each slot vertices of its own, if there is room for all, else all slots the same.
void share_vertices(const SceneFrame& frame) {
  const auto aligned = [](std::size_t bytes) {
    return (bytes + kVertexAlignment - 1) / kVertexAlignment * kVertexAlignment;
  };
  const std::span<SceneSlot> slots = frame.entries.first(frame.header.in_view);
  std::uint64_t all = 0;
  for (const SceneSlot& slot : slots) all += aligned(slot.vertex_bytes);
  frame.header.keeps_vertices = all <= frame.vertices.size();
  unsigned char* at = frame.vertices.data();
  for (SceneSlot& slot : slots) {
    slot.vertices = at;
    slot.held = nullptr;
    if (frame.header.keeps_vertices) at += aligned(slot.vertex_bytes);
  }
}

/// The entries that the rows of all parts of an object take. Above `most` it may be any number above that.
[[nodiscard]] std::size_t row_entries(const Object& object, std::size_t most) {
  std::size_t entries = 0;
  for (std::size_t i = 0; i < object.part_count() && entries <= most; ++i)
    entries += TriangleRows::entries(object.part(i).count);
  return entries;
}

/// Gives memory for rows to each slot for which there is some left.
void share_rows(const SceneFrame& frame) {
  std::span<TriangleRows> left = frame.rows;
  for (SceneSlot& slot : frame.entries.first(frame.header.in_view)) {
    slot.rows = nullptr;
    slot.parts_with_rows = 0;
    if (left.empty() || slot.object->part_count() > UINT16_MAX) continue;
    const std::size_t entries = row_entries(*slot.object, left.size());
    if (entries > left.size()) continue;
    slot.rows = left.data();
    left = left.subspan(entries);
  }
}

}  // namespace

bool is_outside(const SceneSlot& slot, const Rect& rect) {
  const ClipSphere& sphere = slot.sphere;
  const Viewport& viewport = slot.transform.viewport();
  if (rect.empty() || sphere.middle.w + sphere.radius_ahead < slot.transform.near_w() ||
      sphere.middle.w - sphere.radius_ahead > slot.transform.w_range().farthest) {
    return true;
  }
  return is_outside_range(sphere, {sphere.middle.y, sphere.radius_across}, viewport.height, rect.top,
                          rect.bottom) ||
         is_outside_range(sphere, {sphere.middle.x, sphere.radius_across}, viewport.width, rect.left,
                          rect.right);
}

Status prepare(const Scene& scene, const SceneFrame& frame) {
  SceneHeader& header = frame.header;
  constexpr std::size_t kMostLights = std::tuple_size_v<decltype(ObjectLights::lights)>;
  header = {scene.lights, &scene.camera, 0, false, check_lights(scene.lights, kMostLights)};
  if (scene.camera.viewport().width == 0) header.status = Status::kNotReady;
  for (const Object& object : scene.objects) {
    if (!ok(header.status)) break;
    if (object.visible) header.status = add_object(object, scene, frame);
  }
  if (!ok(header.status)) header.in_view = 0;
  share_vertices(frame);
  share_rows(frame);
  return header.status;
}

ObjectLights lights_at(const SceneHeader& header, const Object& object) {
  ObjectLights seen;
  seen.ambient = header.lights.ambient;
  const WorldPoint middle = object.middle();
  std::size_t count = 0;
  for (const SceneLight& light : header.lights.lights)
    seen.lights[count++] = light.seen_from(middle, object.rotation);
  // No normal is turned towards a light without direction, which is the fastest way to have none.
  for (; count < seen.lights.size(); ++count) seen.lights[count] = {Direction{}, Coefficient{}, kWhite};
  constexpr Direction kBack = normalised(0, 0, 1);
  seen.to_eye = object.rotation.to_object(header.camera->rotation().to_object(kBack));
  return seen;
}

}  // namespace arcspan::detail
