// SPDX-License-Identifier: MIT
#include <arcspan/vertex/raster_vertex.hpp>
#include <arcspan/vertex/screen_point.hpp>

namespace arcspan {

ScreenPoint screen_point(const ClipTransform& transform, const ObjectPosition& point) {
  ClipPosition clip = transform(point);
  if (clip.w < transform.near_w()) return {};
  const bool in_guard_band = (outcode(clip, transform.w_range()) & ~kOutsideFar) == 0;
  clip.x = limited(clip.x, clip.w);
  clip.y = limited(clip.y, clip.w);
  const RasterPosition raster = project(clip, transform);
  const Viewport& viewport = transform.viewport();
  const auto from_side = [](std::int32_t from_origin, std::int32_t size) {
    return Subpixel::from_raw(from_origin + ((size >> 1) << Subpixel::kFraction));
  };
  ScreenPoint seen{from_side(raster.x, viewport.width), from_side(raster.y, viewport.height), raster.z, true};
  seen.in_picture = in_guard_band && seen.column() >= 0 && seen.column() < viewport.width &&
                    seen.row() >= 0 && seen.row() < viewport.height;
  return seen;
}

}  // namespace arcspan
