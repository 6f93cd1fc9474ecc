// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstddef>
#include <cstdint>

namespace arcspan {

/// A vertex in clip space with what `Method` interpolates.
template <class Method>
struct ClipVertex {
  ClipPosition position;
  typename Method::Vertex shade;
};

/// A convex polygon. A triangle cut by six planes has at most 9 vertices.
template <class Method>
struct ClipPolygon {
  static constexpr std::size_t kCapacity = 9;
  ClipVertex<Method> vertices[kCapacity];
  std::size_t count;
};

namespace detail {

/// The signed distance of a vertex from a plane of the clip volume, in clip-space units, positive inside.
/// `plane` is one bit of an outcode; kInside gives 0.
[[nodiscard]] ARCSPAN_COLD constexpr std::int32_t plane_distance(const ClipPosition& p, ClipOutcode plane,
                                                                 const WRange& w_range) {
  switch (plane) {
    case kOutsideNear:
      return p.w - w_range.nearest;
    case kOutsideLeft:
      return wrap_add(p.w, p.x);
    case kOutsideRight:
      return wrap_sub(p.w, p.x);
    case kOutsideTop:
      return wrap_add(p.w, p.y);
    case kOutsideBottom:
      return wrap_sub(p.w, p.y);
    case kOutsideFar:
      return wrap_sub(w_range.farthest, p.w);
    case kInside:
      break;
  }
  return 0;
}

/// Sets `vertex` to where the edge from `inside` to `outside` meets a plane, from their distances to it.
/// Edges are always cut in this direction, so that the two triangles of an edge get the same vertex.
template <class Method>
ARCSPAN_OUTLINE ARCSPAN_COLD constexpr void cut(const ClipVertex<Method>& inside,
                                                const ClipVertex<Method>& outside,
                                                std::int32_t inside_distance, std::int32_t outside_distance,
                                                ClipVertex<Method>& vertex) {
  // t = inside / (inside - outside), 30 fraction bits. The difference is below 2^32.
  const std::uint32_t whole =
      static_cast<std::uint32_t>(inside_distance) - static_cast<std::uint32_t>(outside_distance);
  const WideReciprocal inverse = wide_reciprocal(whole);
  const std::int64_t t = static_cast<std::int64_t>(
      (std::uint64_t{static_cast<std::uint32_t>(inside_distance)} * inverse.mantissa) >>
      (inverse.exponent - 30));
  const auto mix = [t](std::int32_t from, std::int32_t to) {
    return static_cast<std::int32_t>(from +
                                     (((std::int64_t{to} - from) * t + (std::int32_t{1} << 29)) >> 30));
  };
  vertex.position = {mix(inside.position.x, outside.position.x), mix(inside.position.y, outside.position.y),
                     mix(inside.position.w, outside.position.w)};
  vertex.shade =
      Method::between(inside.shade, outside.shade, Factor::from_raw(static_cast<std::int32_t>(t >> 15)));
}

/// Clips `in` to one plane, by Sutherland and Hodgman's algorithm; the result is written to `out`.
template <class Method>
ARCSPAN_COLD constexpr void clip_to_plane(const ClipPolygon<Method>& in, ClipPolygon<Method>& out,
                                          ClipOutcode plane, const WRange& w_range) {
  out.count = 0;
  for (std::size_t i = 0; i < in.count; ++i) {
    const ClipVertex<Method>& here = in.vertices[i];
    const ClipVertex<Method>& next = in.vertices[i + 1 == in.count ? 0 : i + 1];
    const std::int32_t d0 = plane_distance(here.position, plane, w_range);
    const std::int32_t d1 = plane_distance(next.position, plane, w_range);
    // A convex polygon gains at most one vertex per plane, so `out` is full only for inconsistent input.
    if (d0 >= 0 && out.count < ClipPolygon<Method>::kCapacity) out.vertices[out.count++] = here;
    if ((d0 >= 0) != (d1 >= 0) && out.count < ClipPolygon<Method>::kCapacity) {
      ClipVertex<Method>& vertex = out.vertices[out.count++];
      if (d0 >= 0) {
        cut(here, next, d0, d1, vertex);
      } else {
        cut(next, here, d1, d0, vertex);
      }
    }
  }
}

}  // namespace detail

/// Clips `polygon` to the near plane, the far plane and the four sides of the guard band. Returns the result,
/// which is in `polygon` or in `spare`; both are overwritten. Its count is 0 if nothing is left.
template <class Method>
[[nodiscard]] ARCSPAN_COLD constexpr const ClipPolygon<Method>& clip_polygon(ClipPolygon<Method>& polygon,
                                                                             ClipPolygon<Method>& spare,
                                                                             const WRange& w_range) {
  ClipPolygon<Method>* from = &polygon;
  ClipPolygon<Method>* to = &spare;
  for (const ClipOutcode plane :
       {kOutsideNear, kOutsideLeft, kOutsideRight, kOutsideTop, kOutsideBottom, kOutsideFar}) {
    detail::clip_to_plane(*from, *to, plane, w_range);
    ClipPolygon<Method>* const result = to;
    to = from;
    from = result;
    if (from->count == 0) break;
  }
  return *from;
}

}  // namespace arcspan
