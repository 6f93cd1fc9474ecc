// SPDX-License-Identifier: MIT
#include <arcspan/draw/scissor.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/scene/screen_extent.hpp>
#include <arcspan/shading/unlit.hpp>

namespace arcspan::detail {

namespace {

using Corner = RasterVertex<Unlit>;

/// Includes the triangles in the picture of the fan of a clipped triangle that show their fronts, or all of
/// them if one does and `together`.
void include_fan(const Corner* corners, std::size_t count, bool together, const Viewport& viewport,
                 ScreenExtent& extent) {
  for (std::size_t i = 2; i < count; ++i) {
    const RasterPosition& p = corners[0].position;
    const RasterPosition& q = corners[i - 1].position;
    const RasterPosition& r = corners[i].position;
    if (doubled_area(p, q, r) >= 0) continue;
    if (together) {
      for (std::size_t k = 0; k < count; ++k) extent = extended(extent, corners[k].position);
      return;
    }
    if (is_beside_picture(p, q, r, viewport)) continue;
    extent = extended(extended(extended(extent, p), q), r);
  }
}

/// Widens from ... from + size to contain a coordinate; `from` is kNowhere if it contains none.
void include_coordinate(std::int32_t at, std::int32_t& from, std::uint32_t& size) {
  const std::int32_t to = from + static_cast<std::int32_t>(size);
  const std::int32_t first = from == ScreenExtent::kNowhere || at < from ? at : from;
  const std::int32_t last = from == ScreenExtent::kNowhere || at > to ? at : to;
  from = first;
  size = static_cast<std::uint32_t>(last - first);
}

}  // namespace

ScreenExtent extended(const ScreenExtent& extent, const RasterPosition& p) {
  ScreenExtent wider = extent;
  include_coordinate(p.x, wider.left, wider.width);
  include_coordinate(p.y, wider.top, wider.height);
  return wider;
}

bool is_beside_picture(const RasterPosition& a, const RasterPosition& b, const RasterPosition& c,
                       const Viewport& viewport) {
  const std::int32_t left = -16 * (viewport.width >> 1);
  const std::int32_t top = -16 * (viewport.height >> 1);
  const std::int32_t right = left + 16 * viewport.width;
  const std::int32_t bottom = top + 16 * viewport.height;
  return (a.x < left && b.x < left && c.x < left) || (a.x > right && b.x > right && c.x > right) ||
         (a.y < top && b.y < top && c.y < top) || (a.y > bottom && b.y > bottom && c.y > bottom);
}

ScreenExtent extended_by_clipped(const MeshView& mesh, const ClipTransform& transform,
                                 const TriangleIndices& t, const ExtentOptions& options,
                                 const ScreenExtent& extent) {
  constexpr Unlit::Lighting kBlack{};
  const VertexStage<Unlit> stage(mesh, transform, kBlack);
  Corner corners[ClipPolygon<Unlit>::kCapacity];
  ScreenExtent wider = extent;
  if (options.edges) {  // as EdgeDrawer does
    const std::size_t count = clip_triangle(stage, t, Facing::kFront, corners);
    if (!options.two_sided) {
      include_fan(corners, count, true, transform.viewport(), wider);
    } else {
      for (std::size_t k = 0; k < count; ++k) wider = extended(wider, corners[k].position);
    }
    return wider;
  }
  for (const Facing facing : {Facing::kFront, Facing::kBack}) {
    if (facing == Facing::kBack && !options.two_sided) break;
    const std::size_t count = clip_triangle(stage, in_clip_order(t, facing), facing, corners);
    include_fan(corners, count, false, transform.viewport(), wider);
  }
  return wider;
}

Rect pixels_of(const ScreenExtent& extent, bool edges, const Viewport& viewport) {
  if (extent.empty()) return {};
  const std::int32_t x = viewport.width >> 1;
  const std::int32_t y = viewport.height >> 1;
  const Rect pixels = edges ? Rect{x + pixel_of(extent.left), y + pixel_of(extent.top),
                                   x + pixel_of(extent.right()) + 1, y + pixel_of(extent.bottom()) + 1}
                            : Rect{x + first_row_at(extent.left), y + first_row_at(extent.top),
                                   x + first_row_at(extent.right()), y + first_row_at(extent.bottom())};
  const Rect seen = intersection(pixels, {0, 0, viewport.width, viewport.height});
  return seen.empty() ? Rect{} : seen;
}

}  // namespace arcspan::detail
