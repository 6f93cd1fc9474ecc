// SPDX-License-Identifier: MIT
#include <arcspan/pick.hpp>

#include <arcspan_c/scene.hpp>
#include <arcspan_c/view.hpp>

using namespace arcspan;

arcspan_status arcspan_pick(arcspan_view* view, int32_t x, int32_t y, arcspan_picked* picked) {
  const Picked found = ok(view->status) ? pick(view->memory, x, y) : Picked{view->status};
  *picked = {};
  if (!ok(found.status) || found.object == nullptr) return static_cast<arcspan_status>(found.status);
  const auto at = static_cast<arcspan_object>(found.object - view->scene.objects);
  arcspan_object object = at;
  while (view->scene.parts[object] == 0) --object;
  *picked = {1, object, static_cast<std::uint16_t>(at - object), static_cast<std::uint32_t>(found.triangle)};
  return ARCSPAN_OK;
}

arcspan_screen_point arcspan_project(const arcspan_view* view, arcspan_point point) {
  const ScreenPoint seen = view->camera.project(c::world_point(point));
  return {seen.x.raw(), seen.y.raw(), seen.in_picture ? 1 : 0};
}
