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

/// The sides of the vertices, those from the `kept`th on found whenever one is asked for.
struct MoreSides {
  const std::uint8_t* sides;
  std::size_t kept;
  const MeshView& mesh;
  PixelSide side;
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t operator()(std::size_t i) const {
    return i < kept ? sides[i] : side(mesh.position(i));
  }
};

/// The first triangle of first ... last, three indices each, whose vertices do not all lie on one side, or
/// `last`. A function of its own, whose loop takes 12 instructions per triangle on a Cortex-M3 by KeptSides.
template <class Index, class Sides>
[[nodiscard]] ARCSPAN_OUTLINE const Index* next_across(const Index* first, const Index* last,
                                                       const Sides& all) {
  const Sides sides = all;
  for (; first != last; first += 3) {
    if ((sides(first[0]) & sides(first[1]) & sides(first[2])) == 0) break;
  }
  return first;
}

/// The triangles of an object that may have a pixel: those across its column and its row.
class PixelTriangles {
 public:
  PixelTriangles(const SceneSlot& slot, const PickSink& sink, bool edges, std::span<std::uint8_t> scratch)
      : mesh_(slot.object->mesh()),
        column_(make_pixel_side(slot, PictureAxis::kColumns, sink.x, edges)),
        row_(make_pixel_side(slot, PictureAxis::kRows, sink.y, edges)) {
    const std::size_t count = mesh_.vertex_count();
    kept_ = count < scratch.size() ? count : scratch.size();
    sides_ = scratch.data();
    if (kept_ == 0) return;
    const PixelSide side = column_;
    const ObjectPosition* position = &mesh_.position(0);
    for (std::uint8_t* at = sides_; at != sides_ + kept_; ++at, ++position)
      *at = static_cast<std::uint8_t>(side(*position));
  }

  /// The first of the triangles i ... end - 1 that may have the pixel, or `end`.
  [[nodiscard]] std::size_t next(std::size_t i, std::size_t end) const {
    return mesh_.indices8() != nullptr ? next_of(mesh_.indices8(), i, end)
                                       : next_of(mesh_.indices16(), i, end);
  }

 private:
  template <class Index>
  [[nodiscard]] std::size_t next_of(const Index* indices, std::size_t i, std::size_t end) const {
    const auto side = [this](std::size_t v) { return row_(mesh_.position(v)); };
    const Index* const last = indices + 3 * end;
    for (const Index* at = indices + 3 * i;; at += 3) {
      at = kept_ == mesh_.vertex_count() ? next_across(at, last, KeptSides{sides_})
                                         : next_across(at, last, MoreSides{sides_, kept_, mesh_, column_});
      if (at == last) return end;
      if ((side(at[0]) & side(at[1]) & side(at[2])) == 0) return static_cast<std::size_t>(at - indices) / 3;
    }
  }

  const MeshView& mesh_;
  PixelSide column_;
  PixelSide row_;
  std::uint8_t* sides_ = nullptr;  ///< of column_, for the first kept_ vertices
  std::size_t kept_ = 0;
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

/// Draws `triangles` of an object; the last one that is nearer than `nearest`, the depth in the buffer, is
/// picked.
template <class Triangles>
void pick_object(const SceneSlot& slot, std::span<const PickUse> uses, const Triangles& triangles,
                 PickSink& sink, const DepthBuffer& depth, const std::uint16_t& nearest, Picked& picked) {
  const Object& object = *slot.object;
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

/// triangles_of(slot, sink) are those of an object that may have the pixel.
template <class TrianglesOf>
[[nodiscard]] Picked pick_among(const SceneFrame& frame, std::span<const PickUse> uses, std::int32_t x,
                                std::int32_t y, const TrianglesOf& triangles_of) {
  Picked picked{frame.header.camera == nullptr ? Status::kNotReady : frame.header.status};
  if (!ok(picked.status)) return picked;
  const Viewport& viewport = frame.header.camera->viewport();
  if (x < 0 || y < 0 || x >= viewport.width || y >= viewport.height) return picked;
  PickSink sink{x, y};
  std::uint16_t nearest = DepthBuffer::kFarthest;
  const DepthBuffer depth({&nearest, 1}, sink.bounds());
  for (const std::uint16_t i : frame.order.first(frame.header.in_view)) {
    const SceneSlot& slot = frame.entries[i];
    if (is_outside(slot, sink.bounds())) continue;
    pick_object(slot, uses, triangles_of(slot, sink), sink, depth, nearest, picked);
    if (!ok(picked.status)) break;
  }
  return picked;
}

}  // namespace

Picked pick_in(const SceneFrame& frame, std::span<const PickUse> uses, std::span<std::uint8_t> scratch,
               std::int32_t x, std::int32_t y) {
  return pick_among(frame, uses, x, y, [&](const SceneSlot& slot, const PickSink& sink) {
    return PixelTriangles(slot, sink, draws_edges(*slot.object, uses), scratch);
  });
}

Picked pick_posed_in(const SceneFrame& frame, std::span<const PickUse> uses, std::int32_t x, std::int32_t y) {
  return pick_among(frame, uses, x, y, [](const SceneSlot&, const PickSink&) { return AllTriangles{}; });
}

}  // namespace arcspan::detail
