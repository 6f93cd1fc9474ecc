// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// The vertex half-way along an edge on the screen, with the shading half-way along its arc. Does not depend
/// on the edge's direction, so that both triangles of an edge split it alike and no gap opens.
template <class Method>
[[nodiscard]] ARCSPAN_COLD_OUTLINE constexpr RasterVertex<Method> middle_vertex(
    const RasterVertex<Method>& a, const RasterVertex<Method>& b) {
  RasterVertex<Method> middle;
  middle.position = {static_cast<std::int16_t>((a.position.x + b.position.x) >> 1),
                     static_cast<std::int16_t>((a.position.y + b.position.y) >> 1),
                     static_cast<std::uint16_t>((std::uint32_t{a.position.z} + b.position.z) >> 1)};
  middle.shade = Method::between(a.shade, b.shade, Factor::of(0.5));
  return middle;
}

/// How often a part of a triangle may be split again. Two halvings bring an edge of 180 degrees below the 60
/// that arcs are good for, but the edges between middles of a spherical triangle are more than half as wide;
/// with 5, none of 10^5 triangles within a cone of 90 degrees was left too wide (with 3: 64).
inline constexpr int kMaxSplits = 5;

namespace detail {

/// Halves ab.
template <class Method, class Emit>
ARCSPAN_COLD constexpr void split_one_edge(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                           const RasterVertex<Method>& c, const Emit& emit) {
  const RasterVertex<Method> m = middle_vertex(a, b);
  emit(a, m, c);
  emit(m, b, c);
}

/// Halves ab and bc.
template <class Method, class Emit>
ARCSPAN_COLD constexpr void split_two_edges(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                            const RasterVertex<Method>& c, const Emit& emit) {
  const RasterVertex<Method> m = middle_vertex(a, b);
  const RasterVertex<Method> n = middle_vertex(b, c);
  emit(m, b, n);
  emit(a, m, n);
  emit(a, n, c);
}

}  // namespace detail

/// Calls `emit(a, b, c)` for the parts of a triangle whose normals are close enough for its method. Every
/// edge that is too wide is halved at once, whatever the other two are: an edge's fate is its own, so that no
/// gap opens towards the triangle behind it, however deep either may be split. Calls itself, so `emit` should
/// be a call and no more.
template <class Method, class Emit>
ARCSPAN_COLD constexpr void split_triangle(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                           const RasterVertex<Method>& c, Emit& emit,
                                           int splits = kMaxSplits) {
  const bool ab = splits > 0 && Method::too_wide(a.shade, b.shade);
  const bool bc = splits > 0 && Method::too_wide(b.shade, c.shade);
  const bool ca = splits > 0 && Method::too_wide(c.shade, a.shade);
  const auto again = [&emit, splits](const RasterVertex<Method>& p, const RasterVertex<Method>& q,
                                     const RasterVertex<Method>& r) {
    split_triangle(p, q, r, emit, splits - 1);
  };
  if (!ab && !bc && !ca) {
    emit(a, b, c);
  } else if (ab && bc && ca) {
    const RasterVertex<Method> m = middle_vertex(a, b);
    const RasterVertex<Method> n = middle_vertex(b, c);
    const RasterVertex<Method> o = middle_vertex(c, a);
    again(a, m, o);
    again(m, b, n);
    again(o, n, c);
    again(m, n, o);
  } else if (ab && bc) {
    detail::split_two_edges(a, b, c, again);
  } else if (bc && ca) {
    detail::split_two_edges(b, c, a, again);
  } else if (ca && ab) {
    detail::split_two_edges(c, a, b, again);
  } else if (ab) {
    detail::split_one_edge(a, b, c, again);
  } else if (bc) {
    detail::split_one_edge(b, c, a, again);
  } else {
    detail::split_one_edge(c, a, b, again);
  }
}

}  // namespace arcspan
