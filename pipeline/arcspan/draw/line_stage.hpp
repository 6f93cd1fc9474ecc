// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/clip/clip_polygon.hpp>
#include <arcspan/draw/scissor.hpp>
#include <arcspan/prepare/line_command.hpp>
#include <arcspan/shading/unlit.hpp>
#include <arcspan/span/line_rows.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan {

/// How much nearer lines and points are drawn than they are, in units of the 16-bit depth. A line has the
/// depth of its own points, a pixel of a surface that of the pixel's centre: without a bias, a surface hides
/// about half of the pixels of its edges. It shows an edge wherever the surface's depth changes by less than
/// twice the bias per pixel. Fog is that of a line's own depth.
struct DepthBias {
  static constexpr std::uint16_t kDefault = 256;

  std::uint16_t units = kDefault;
};

namespace detail {

/// True if the rectangle of the pixels from a to b meets the scissor.
[[nodiscard]] constexpr bool has_pixels(const Scissor& scissor, const RasterPosition& a,
                                        const RasterPosition& b) {
  const RasterOrigin& origin = scissor.origin();
  const auto meets = [](std::int32_t p, std::int32_t q, std::int32_t begin, std::int32_t end) {
    return pixel_of(p > q ? p : q) >= begin && pixel_of(p < q ? p : q) < end;
  };
  const Rect& rect = scissor.rect();
  return meets(a.y, b.y, rect.top - origin.y, rect.bottom - origin.y) &&
         meets(a.x, b.x, rect.left - origin.x, rect.right - origin.x);
}

/// Draws the line from a to b, which has_pixels() in the scissor of `target`.
template <OneColour Method, class Target>
[[nodiscard]] ARCSPAN_OUTLINE constexpr Status draw_line_between(const RasterPosition& a,
                                                                 const RasterPosition& b, std::uint16_t bias,
                                                                 const RasterOrigin& origin,
                                                                 const Target& target) {
  LineCommand line;
  prepare_line(a, b, bias, line);
  return draw_line_command<Method>(line, origin, target);
}

/// Clips the line from p to q and sets a and b to the ends of the rest on the screen. Returns false if
/// nothing is left.
[[nodiscard]] ARCSPAN_OUTLINE ARCSPAN_COLD inline bool clip_line(const ClipTransform& transform,
                                                                 ClipPosition p, ClipPosition q,
                                                                 RasterPosition& a, RasterPosition& b) {
  for (const ClipOutcode plane : kClipPlanes) {
    const std::int32_t p_distance = plane_distance(p, plane, transform.w_range());
    const std::int32_t q_distance = plane_distance(q, plane, transform.w_range());
    if (p_distance < 0 && q_distance < 0) return false;
    const ClipVertex<Unlit> from{p, {}};
    const ClipVertex<Unlit> to{q, {}};
    ClipVertex<Unlit> crossing{};
    if (p_distance < 0) {
      cut(to, from, q_distance, p_distance, crossing);
      p = crossing.position;
    }
    if (q_distance < 0) {
      cut(from, to, p_distance, q_distance, crossing);
      q = crossing.position;
    }
  }
  a = project(p, transform);
  b = project(q, transform);
  return true;
}

}  // namespace detail

}  // namespace arcspan
