// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan {

/// project() where near/w is not needed.
[[nodiscard]] inline RasterPosition project(const ClipPosition& p, const ClipTransform& transform) {
  std::int32_t near_over_w;
  return project(p, transform, near_over_w);
}

/// Sets `position` to project(). At -Os a function whose arguments fit registers.
ARCSPAN_INLINE_EXCEPT_AT_OS inline void project_to(std::int32_t x, std::int32_t y, std::int32_t w,
                                                   const ClipTransform& transform, RasterPosition& position) {
  std::int32_t near_over_w;
  position = project({x, y, w}, transform, near_over_w);
}

/// project() where it is, as a function of its own.
[[nodiscard]] ARCSPAN_OUTLINE inline RasterPosition project_in_perspective(const ClipPosition& p,
                                                                           const ClipTransform& transform,
                                                                           std::int32_t& near_over_w) {
  return project(p, transform, near_over_w);
}

}  // namespace arcspan
