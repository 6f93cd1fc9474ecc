// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/triangle.hpp>

#include <cstdint>

namespace arcspan {

/// The vertex half-way along an edge on the screen, with the shading half-way along its arc. Does not depend
/// on the edge's direction, so that both triangles of an edge split it alike and no gap opens.
template <class Method>
[[nodiscard]] constexpr RasterVertex<Method> middle_vertex(const RasterVertex<Method>& a,
                                                           const RasterVertex<Method>& b) {
  RasterVertex<Method> middle;
  middle.position = {static_cast<std::int16_t>((a.position.x + b.position.x) >> 1),
                     static_cast<std::int16_t>((a.position.y + b.position.y) >> 1),
                     static_cast<std::uint16_t>((a.position.z + b.position.z) >> 1)};
  middle.shade = Method::between(a.shade, b.shade, Factor::of(0.5));
  return middle;
}

/// Halving 180 degrees three times leaves less than the 60 that arcs are good for.
inline constexpr int kMaxSplits = 3;

/// Calls `emit(a, b, c)` for the parts of a triangle whose normals are close enough for its method. Every
/// edge that is too wide is halved, whatever the other two are: the decision is the edge's own.
template <int Splits, class Method, class Emit>
constexpr void split_triangle(const RasterVertex<Method>& a, const RasterVertex<Method>& b,
                              const RasterVertex<Method>& c, Emit& emit) {
  if constexpr (Splits == 0) {
    emit(a, b, c);
  } else {
    const bool ab = Method::too_wide(a.shade, b.shade);
    const bool bc = Method::too_wide(b.shade, c.shade);
    const bool ca = Method::too_wide(c.shade, a.shade);
    const auto again = [&emit](const RasterVertex<Method>& p, const RasterVertex<Method>& q,
                               const RasterVertex<Method>& r) { split_triangle<Splits - 1>(p, q, r, emit); };
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
    } else if (ab && !ca) {
      // One wide edge, or ab and bc: cut from its middle to the opposite corner, the rest follows.
      const RasterVertex<Method> m = middle_vertex(a, b);
      again(a, m, c);
      again(m, b, c);
    } else if (bc && !ab) {
      const RasterVertex<Method> m = middle_vertex(b, c);
      again(b, m, a);
      again(m, c, a);
    } else {
      const RasterVertex<Method> m = middle_vertex(c, a);
      again(c, m, b);
      again(m, a, b);
    }
  }
}

}  // namespace arcspan
