// SPDX-License-Identifier: MIT
#include <arcspan/scene/pick_frame.hpp>
#include <arcspan/scene/pixel_side.hpp>

namespace arcspan::detail {

namespace {

/// The sides of the vertices, found before.
struct KeptSides {
  const std::uint8_t* sides;
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t operator()(std::size_t i) const { return sides[i]; }
};

/// The sides of the vertices, found whenever one is asked for.
struct FoundSides {
  const MeshView& mesh;
  const PixelSide& side;
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t operator()(std::size_t i) const {
    return side(mesh.position(i));
  }
};

/// The first of the triangles i ... end - 1 whose vertices do not all lie on one side, or `end`.
template <class Index, class Sides>
[[nodiscard]] std::size_t next_across(const Index* indices, std::size_t i, std::size_t end, Sides sides) {
  const Index* at = indices + 3 * i;
  for (; i < end; ++i, at += 3) {
    if ((sides(at[0]) & sides(at[1]) & sides(at[2])) == 0) break;
  }
  return i;
}

/// The triangles of an object that may have a pixel: those across its column and its row.
class PixelTriangles {
 public:
  PixelTriangles(const SceneSlot& slot, const PickSink& sink, bool edges, std::span<std::uint8_t> scratch)
      : mesh_(slot.object->mesh()),
        column_(make_pixel_side(slot, PictureAxis::kColumns, sink.x, edges)),
        row_(make_pixel_side(slot, PictureAxis::kRows, sink.y, edges)) {
    const std::size_t count = mesh_.vertex_count();
    if (count > scratch.size()) return;
    sides_ = scratch.data();
    const PixelSide side = column_;
    for (std::size_t i = 0; i < count; ++i) sides_[i] = static_cast<std::uint8_t>(side(mesh_.position(i)));
  }

  /// The first of the triangles i ... end - 1 that may have the pixel, or `end`.
  [[nodiscard]] std::size_t next(std::size_t i, std::size_t end) const {
    for (;; ++i) {
      i = next_in_column(i, end);
      if (i == end) return end;
      const TriangleIndices t = mesh_.triangle(i);
      const FoundSides sides{mesh_, row_};
      if ((sides(t.a) & sides(t.b) & sides(t.c)) == 0) return i;
    }
  }

 private:
  [[nodiscard]] std::size_t next_in_column(std::size_t i, std::size_t end) const {
    const FoundSides found{mesh_, column_};
    if (mesh_.indices8() != nullptr) {
      return sides_ != nullptr ? next_across(mesh_.indices8(), i, end, KeptSides{sides_})
                               : next_across(mesh_.indices8(), i, end, found);
    }
    return sides_ != nullptr ? next_across(mesh_.indices16(), i, end, KeptSides{sides_})
                             : next_across(mesh_.indices16(), i, end, found);
  }

  const MeshView& mesh_;
  PixelSide column_;
  PixelSide row_;
  std::uint8_t* sides_ = nullptr;  ///< of column_, or null if there is no room
};

[[nodiscard]] const PickUse& use_of(std::span<const PickUse> uses, const SceneMaterial& material) {
  std::size_t i = 0;
  while (uses[i].use != material.use()) ++i;  // prepare_scene() has found it in the list
  return uses[i];
}

[[nodiscard]] bool draws_edges(const Object& object, std::span<const PickUse> uses) {
  for (std::size_t i = 0; i < object.part_count(); ++i) {
    if (use_of(uses, *object.part(i).material).edges) return true;
  }
  return false;
}

/// Draws the triangles of an object that may have the pixel; the last one that is nearer than `nearest`, the
/// depth in the buffer, is picked.
void pick_object(const SceneSlot& slot, std::span<const PickUse> uses, std::span<std::uint8_t> scratch,
                 PickSink& sink, const DepthBuffer& depth, const std::uint16_t& nearest, Picked& picked) {
  const Object& object = *slot.object;
  const PixelTriangles triangles(slot, sink, draws_edges(object, uses), scratch);
  for (std::size_t number = 0; number < object.part_count(); ++number) {
    const Part part = object.part(number);
    const PickUse& use = use_of(uses, *part.material);
    const PickCall call{slot, *part.material, sink, depth};
    const std::size_t end = part.first + part.count;
    for (std::size_t i = triangles.next(part.first, end); i < end; i = triangles.next(i + 1, end)) {
      picked.status = use.draw(call, object.mesh().part(i, 1));
      if (!ok(picked.status)) return;
      if (nearest < picked.depth) picked = {Status::kOk, &object, number, i, nearest};
    }
  }
}

}  // namespace

Picked pick_in(const SceneFrame& frame, std::span<const PickUse> uses, std::span<std::uint8_t> scratch,
               std::int32_t x, std::int32_t y) {
  Picked picked{frame.header.camera == nullptr ? Status::kNotReady : frame.header.status};
  if (!ok(picked.status)) return picked;
  const Viewport& viewport = frame.header.camera->viewport();
  if (x < 0 || y < 0 || x >= viewport.width || y >= viewport.height) return picked;
  PickSink sink{x, y};
  std::uint16_t nearest = DepthBuffer::kFarthest;
  const DepthBuffer depth({&nearest, 1}, sink.bounds());
  depth.clear();
  for (const std::uint16_t i : frame.order.first(frame.header.in_view)) {
    const SceneSlot& slot = frame.slots[i];
    if (is_outside(slot, sink.bounds())) continue;
    pick_object(slot, uses, scratch, sink, depth, nearest, picked);
    if (!ok(picked.status)) break;
  }
  return picked;
}

}  // namespace arcspan::detail
