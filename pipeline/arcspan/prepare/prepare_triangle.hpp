// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>

#include <cstdint>

namespace arcspan {

/// Returns true inside the guard band, [-1024, 1024) pixels, within which edges and areas fit their words.
[[nodiscard]] constexpr bool in_guard_band(const RasterPosition& p) {
  constexpr std::uint32_t kHalf = kGuardBand << Subpixel::kFraction;
  return ((static_cast<std::uint32_t>(p.x) + kHalf) | (static_cast<std::uint32_t>(p.y) + kHalf)) < 2 * kHalf;
}

/// Makes the command that draws a triangle of either winding. Returns false if there is nothing to draw: if
/// the triangle has no row among `rows`, the rows of the viewport, if it has no area, or if a vertex is
/// outside the guard band.
template <class Method>
[[nodiscard]] constexpr bool prepare_triangle(const typename Method::Lighting& lighting,
                                              const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                              const RasterVertex<Method>& c,
                                              const typename Method::Face& face, const RowRange& rows,
                                              TriangleCommand<Method>& command) {
  if (!in_guard_band(a.position) || !in_guard_band(b.position) || !in_guard_band(c.position)) return false;
  return prepare_inside(lighting, a, b, c, face, rows, command);
}

}  // namespace arcspan
