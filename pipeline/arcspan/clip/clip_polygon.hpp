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

namespace detail {

/// The planes of the clip volume, in the order in which they cut.
inline constexpr ClipOutcode kClipPlanes[] = {kOutsideNear, kOutsideLeft,   kOutsideRight,
                                              kOutsideTop,  kOutsideBottom, kOutsideFar};

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
  // t = inside / (inside - outside). The difference is below 2^32.
  const auto within = static_cast<std::uint32_t>(inside_distance);
  const WideReciprocal per = wide_reciprocal(within - static_cast<std::uint32_t>(outside_distance));
  const CutFraction t{static_cast<std::int32_t>(std::uint64_t{within} * per.mantissa >> (per.exponent - 30))};
  const ClipPosition& from = inside.position;
  const ClipPosition& to = outside.position;
  vertex.position = {t.between(from.x, to.x), t.between(from.y, to.y), t.between(from.w, to.w)};
  vertex.shade = Method::between(inside.shade, outside.shade, t);
}

}  // namespace detail

/// A convex polygon, at first a triangle. Each of six cuts adds a vertex at most. To save stack, a cut writes
/// its result into the same array: the vertices lie in a ring, and the result begins behind the last one.
template <class Method>
class ClipPolygon {
 public:
  static constexpr std::size_t kCapacity = 9;

  /// A triangle; its three vertices are to be set by operator[].
  constexpr ClipPolygon() = default;

  [[nodiscard]] constexpr std::size_t count() const { return count_; }
  [[nodiscard]] constexpr const ClipVertex<Method>& operator[](std::size_t i) const {
    return vertices_[wrapped(first_ + i)];
  }
  [[nodiscard]] constexpr ClipVertex<Method>& operator[](std::size_t i) {
    return vertices_[wrapped(first_ + i)];
  }

  /// Cuts off what is outside of `plane`, one bit of ClipOutcode, by Sutherland and Hodgman's algorithm. Once
  /// for each plane: there is room for six cuts.
  ARCSPAN_COLD constexpr void clip(ClipOutcode plane, const WRange& w_range) {
    if (count_ == 0) return;  // no first vertex to copy
    const ClipVertex<Method> begin = vertices_[first_];
    std::size_t read = first_;
    std::size_t write = wrapped(first_ + count_);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const ClipVertex<Method>& here = vertices_[read];
      read = wrapped(read + 1);
      const ClipVertex<Method>& next = i + 1 == count_ ? begin : vertices_[read];
      const std::int32_t d0 = detail::plane_distance(here.position, plane, w_range);
      const std::int32_t d1 = detail::plane_distance(next.position, plane, w_range);
      // A plane adds at most one vertex to a convex polygon. What rounding makes concave could gain more, for
      // which there are no slots.
      if (d0 >= 0 && kept <= i + 1) {
        vertices_[write] = here;
        write = wrapped(write + 1);
        ++kept;
      }
      if ((d0 >= 0) != (d1 >= 0) && kept <= i + 1) {
        const bool out = d0 >= 0;
        detail::cut(out ? here : next, out ? next : here, out ? d0 : d1, out ? d1 : d0, vertices_[write]);
        write = wrapped(write + 1);
        ++kept;
      }
    }
    first_ = wrapped(first_ + count_);
    count_ = kept;
  }

 private:
  /// While vertex i is read, i + 2 may have been written behind the old ones, but not over it.
  static constexpr std::size_t kSlots = kCapacity + 2;
  [[nodiscard]] static constexpr std::size_t wrapped(std::size_t slot) {
    return slot < kSlots ? slot : slot - kSlots;
  }

  ClipVertex<Method> vertices_[kSlots];
  std::size_t first_ = 0;
  std::size_t count_ = 3;
};

/// Clips `polygon` to the near plane, the far plane and the four sides of the guard band. Its count is 0 if
/// nothing is left.
template <class Method>
ARCSPAN_COLD constexpr void clip_polygon(ClipPolygon<Method>& polygon, const WRange& w_range) {
  for (const ClipOutcode plane : detail::kClipPlanes) polygon.clip(plane, w_range);
}

}  // namespace arcspan
