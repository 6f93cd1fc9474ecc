// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// Returns the vertex half-way along an edge on the screen, with the shading half-way along its arc. It does
/// not depend on the order of the two ends, so both triangles of an edge get the same vertex and no gap
/// opens.
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

/// The depth to which a triangle may be split. Two halvings bring an edge of 180 degrees below the 60 degrees
/// that arcs support, but the edges between the middles of a spherical triangle are more than half as wide as
/// its own. With depth 5 none of 10^5 triangles within a cone of 90 degrees stayed too wide; with depth 3, 64
/// did.
inline constexpr int kMaxSplits = 5;

namespace detail {

/// Splits a triangle in two at the middle of ab.
template <class Method, class Emit>
ARCSPAN_COLD constexpr void split_one_edge(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                           const RasterVertex<Method>& c, const Emit& emit) {
  const RasterVertex<Method> m = middle_vertex(a, b);
  emit(a, m, c);
  emit(m, b, c);
}

/// Splits a triangle in three at the middles of ab and bc.
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

/// Splits a triangle until the normals of every part are close enough for its method, at most `splits` times
/// in depth, and calls `emit(a, b, c)` for each part. Every edge that is too wide is halved, whatever the
/// other two are. Whether an edge is halved depends on that edge alone, so no gap opens towards its other
/// triangle. The function is recursive; `emit` should contain one call only, to keep its frame small.
template <class Method, class Emit>
ARCSPAN_COLD constexpr void split_triangle(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                                           const RasterVertex<Method>& c, Emit& emit,
                                           int splits = kMaxSplits) {
  const bool ab = splits > 0 && Method::too_wide(a.shade, b.shade);
  const bool bc = splits > 0 && Method::too_wide(b.shade, c.shade);
  const bool ca = splits > 0 && Method::too_wide(c.shade, a.shade);
  const auto split_part = [&emit, splits](const RasterVertex<Method>& p, const RasterVertex<Method>& q,
                                          const RasterVertex<Method>& r) {
    split_triangle(p, q, r, emit, splits - 1);
  };
  if (!ab && !bc && !ca) {
    emit(a, b, c);
  } else if (ab && bc && ca) {
    const RasterVertex<Method> m = middle_vertex(a, b);
    const RasterVertex<Method> n = middle_vertex(b, c);
    const RasterVertex<Method> o = middle_vertex(c, a);
    split_part(a, m, o);
    split_part(m, b, n);
    split_part(o, n, c);
    split_part(m, n, o);
  } else if (ab && bc) {
    detail::split_two_edges(a, b, c, split_part);
  } else if (bc && ca) {
    detail::split_two_edges(b, c, a, split_part);
  } else if (ca && ab) {
    detail::split_two_edges(c, a, b, split_part);
  } else if (ab) {
    detail::split_one_edge(a, b, c, split_part);
  } else if (bc) {
    detail::split_one_edge(b, c, a, split_part);
  } else {
    detail::split_one_edge(c, a, b, split_part);
  }
}

}  // namespace arcspan
