// SPDX-License-Identifier: MIT
#include <arcspan/scene/pick_frame.hpp>

namespace arcspan::detail {

namespace {

/// Draws an object; the last triangle that is nearer than `nearest`, the depth in the buffer, is picked.
void pick_object(const SceneSlot& slot, std::span<const PickUse> uses, PickSink& sink,
                 const DepthBuffer& depth, const std::uint16_t& nearest, Picked& picked) {
  const Object& object = *slot.object;
  for (std::size_t number = 0; number < object.part_count(); ++number) {
    const Part part = object.part(number);
    std::size_t use = 0;
    while (uses[use].use != part.material->use()) ++use;  // prepare_scene() has found it in the list
    const PickCall call{slot, *part.material, sink, depth};
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      picked.status = uses[use].draw(call, object.mesh().part(i, 1));
      if (!ok(picked.status)) return;
      if (nearest < picked.depth) picked = {Status::kOk, &object, number, i, nearest};
    }
  }
}

}  // namespace

Picked pick_posed_in(const SceneFrame& frame, std::span<const PickUse> uses, std::int32_t x, std::int32_t y) {
  Picked picked{frame.header.camera == nullptr ? Status::kNotReady : frame.header.status};
  if (!ok(picked.status)) return picked;
  const Viewport& viewport = frame.header.camera->viewport();
  if (x < 0 || y < 0 || x >= viewport.width || y >= viewport.height) return picked;
  PickSink sink{x, y};
  std::uint16_t nearest = DepthBuffer::kFarthest;
  const DepthBuffer depth({&nearest, 1}, sink.bounds());
  depth.clear();
  for (const std::uint16_t i : frame.order.first(frame.header.in_view)) {
    if (is_outside(frame.entries[i], sink.bounds())) continue;
    pick_object(frame.entries[i], uses, sink, depth, nearest, picked);
    if (!ok(picked.status)) break;
  }
  return picked;
}

}  // namespace arcspan::detail
