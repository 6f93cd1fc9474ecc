// SPDX-License-Identifier: MIT
#pragma once

// How far outlines are from a circle.
#include <arcspan/outline/outline_list.hpp>

#include <cmath>

namespace arcspan::test {

/// The mean distance of outlines from a circle around the raster origin, in pixels.
[[nodiscard]] inline double deviation_from_circle(const OutlineList& outlines, double radius) {
  double sum = 0;
  double length = 0;
  for (const OutlineEdge& e : outlines.edges()) {
    const double part = std::hypot(e.to.x - e.from.x, e.to.y - e.from.y) / 16;
    for (int i = 0; i < 16; ++i) {
      const double t = (i + 0.5) / 16;
      const double x = e.from.x + t * (e.to.x - e.from.x);
      const double y = e.from.y + t * (e.to.y - e.from.y);
      sum += part * std::abs(std::hypot(x, y) / 16 - radius);
    }
    length += 16 * part;
  }
  return sum / length;
}

}  // namespace arcspan::test
