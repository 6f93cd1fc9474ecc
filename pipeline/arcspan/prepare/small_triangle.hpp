// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <bit>
#include <cstdint>

/// Triangles of a few pixels. Setting up edges, planes and rows for them would take most of their time, so
/// their pixels are found by edge functions over their box, and everything that is interpolated follows from
/// barycentric coordinates at each pixel (decision 26).
namespace arcspan {

/// A triangle is small if its vertices are at most this many pixels apart, along x and along y.
inline constexpr std::int32_t kSmallSize = 7;

/// Returns true if the triangle is small.
[[nodiscard]] constexpr bool is_small(const RasterPosition& a, const RasterPosition& b,
                                      const RasterPosition& c) {
  const auto apart = [](std::int32_t p, std::int32_t q) {
    constexpr std::int32_t kMost = kSmallSize << Subpixel::kFraction;
    return static_cast<std::uint32_t>(p - q + kMost) > 2 * static_cast<std::uint32_t>(kMost);
  };
  if (apart(a.x, b.x) || apart(a.y, b.y)) return false;
  return !(apart(a.x, c.x) || apart(b.x, c.x) || apart(a.y, c.y) || apart(b.y, c.y));
}

/// The edge function of an edge: twice the area of the triangle between the edge and a point, in 256ths of a
/// square pixel, positive inside. All values are exact, and below 2^16 in magnitude within the box of a small
/// triangle.
struct EdgeFunction {
  std::int32_t at;  ///< at the centre of the box's first pixel
  std::int32_t dx;  ///< change per pixel
  std::int32_t dy;  ///< change per row
};

/// The pixels of a small triangle in a row: columns first ... first + count - 1 of the box.
struct SmallSpan {
  std::uint8_t first;
  std::uint8_t count;
};

/// The command of a small triangle for the span stage, without its shading. It consists of integers, like a
/// TriangleCommand; docs/triangle-command.md describes both.
struct SmallTriangle {
  /// Pixels: the box's first column and row, relative to the raster origin, and its size.
  std::int32_t column;
  std::int32_t row;
  std::int32_t columns;
  std::int32_t rows;
  /// The rows of the triangle, end_row excluded, beyond the limits too.
  std::int32_t first_row;
  std::int32_t end_row;
  EdgeFunction ab;
  EdgeFunction ca;
  /// 2^16 / (twice the area in 256ths of a square pixel) = inverse * 2^-shift, rounded down.
  std::uint32_t inverse;
  int shift;
  std::int32_t db;  ///< change of the barycentric coordinate of vertex b per pixel, 16 fraction bits
  std::int32_t dc;
  std::int32_t z;   ///< depth of vertex a
  std::int32_t zb;  ///< what vertex b is deeper
  std::int32_t zc;
  Linear dz;  ///< change of the depth per pixel
  SmallSpan spans[kSmallSize];

  /// Returns a barycentric coordinate from its edge function at a point inside: 16 fraction bits, rounded
  /// down, so that the sum of all three is at most 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t coordinate(std::int32_t value) const {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(value) * inverse) >> shift);
  }
  /// Returns the depth at the barycentric coordinates b and c. It is within 7 of the plane through the
  /// vertices and never outside of their depths.
  [[nodiscard]] ARCSPAN_INLINE constexpr Linear depth(std::int32_t b, std::int32_t c) const {
    const std::int32_t part = wrap_add(wrap_mul(zb, b >> 1), wrap_mul(zc, c >> 1));  // 15 fraction bits
    return Linear::from_raw((z << Linear::kFraction) + (part >> (15 - Linear::kFraction)));
  }
};

namespace detail {

/// Makes the edge function of the edge from p to q, inside being on the left as seen on the screen (y down).
/// Returns 0 if a point on the edge is inside, as it is on a left edge or on a top edge, otherwise -1.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t make_edge_function(const RasterPosition& p,
                                                                       const RasterPosition& q,
                                                                       const SmallTriangle& triangle,
                                                                       EdgeFunction& edge) {
  const std::int32_t dx = q.x - p.x;
  const std::int32_t dy = q.y - p.y;
  edge.at = dy * (triangle.column * 16 + 8 - p.x) - dx * (triangle.row * 16 + 8 - p.y);
  edge.dx = dy * 16;
  edge.dy = dx * -16;
  return dy > 0 || (dy == 0 && dx < 0) ? 0 : -1;
}

/// The three edge functions at a pixel, less 1 where a point on the edge is outside.
struct EdgeValues {
  std::int32_t ab;
  std::int32_t bc;
  std::int32_t ca;

  [[nodiscard]] ARCSPAN_INLINE constexpr bool inside() const { return (ab | bc | ca) >= 0; }
  ARCSPAN_INLINE constexpr void add(const EdgeValues& step) {
    ab += step.ab;
    bc += step.bc;
    ca += step.ca;
  }
};

/// Finds the pixels of every row. Returns false if there are none.
[[nodiscard]] ARCSPAN_INLINE constexpr bool find_spans(SmallTriangle& triangle, EdgeValues first,
                                                       const EdgeValues& per_pixel,
                                                       const EdgeValues& per_row) {
  const std::int32_t columns = triangle.columns;
  SmallSpan* span = triangle.spans;
  SmallSpan* const end = span + triangle.rows;
  std::int32_t found = 0;
  for (; span != end; ++span, first.add(per_row)) {
    EdgeValues at = first;
    std::int32_t column = 0;
    while (!at.inside() && ++column != columns) at.add(per_pixel);
    span->first = static_cast<std::uint8_t>(column);
    const std::int32_t begin = column;
    if (column != columns) {
      do {
        at.add(per_pixel);
      } while (++column != columns && at.inside());
    }
    span->count = static_cast<std::uint8_t>(column - begin);
    found |= column - begin;
  }
  return found != 0;
}

}  // namespace detail

/// Columns and rows relative to the raster origin, first ... end - 1 each.
struct SmallLimits {
  std::int32_t left;
  std::int32_t right;
  std::int32_t top;
  std::int32_t bottom;
};

/// Finds the pixels of a small triangle within `limits`. `a`, `b`, `c` must be a small triangle with
/// doubled_area() < 0. Returns false, with `triangle` partly set, if there are none. The same pixels are
/// found as by TriangleCommand, whatever the limits are.
[[nodiscard]] ARCSPAN_OUTLINE constexpr bool cover_small_triangle(const RasterPosition& a,
                                                                  const RasterPosition& b,
                                                                  const RasterPosition& c,
                                                                  const SmallLimits& limits,
                                                                  SmallTriangle& triangle) {
  const auto least = [](std::int32_t p, std::int32_t q, std::int32_t r) {
    const std::int32_t less = p < q ? p : q;
    return less < r ? less : r;
  };
  const auto most = [](std::int32_t p, std::int32_t q, std::int32_t r) {
    const std::int32_t more = p > q ? p : q;
    return more > r ? more : r;
  };
  const std::int32_t left = first_row_at(least(a.x, b.x, c.x));
  const std::int32_t right = first_row_at(most(a.x, b.x, c.x));
  const std::int32_t top = first_row_at(least(a.y, b.y, c.y));
  const std::int32_t bottom = first_row_at(most(a.y, b.y, c.y));
  triangle.first_row = top;
  triangle.end_row = bottom;
  triangle.column = left > limits.left ? left : limits.left;
  triangle.row = top > limits.top ? top : limits.top;
  triangle.columns = (right < limits.right ? right : limits.right) - triangle.column;
  triangle.rows = (bottom < limits.bottom ? bottom : limits.bottom) - triangle.row;
  if (triangle.columns <= 0 || triangle.rows <= 0) return false;
  EdgeFunction bc;
  const std::int32_t ab_tie = detail::make_edge_function(a, b, triangle, triangle.ab);
  const std::int32_t bc_tie = detail::make_edge_function(b, c, triangle, bc);
  const std::int32_t ca_tie = detail::make_edge_function(c, a, triangle, triangle.ca);
  return detail::find_spans(triangle, {triangle.ab.at + ab_tie, bc.at + bc_tie, triangle.ca.at + ca_tie},
                            {triangle.ab.dx, bc.dx, triangle.ca.dx}, {triangle.ab.dy, bc.dy, triangle.ca.dy});
}

/// Prepares the barycentric coordinates and the depth of a small triangle with pixels.
constexpr void prepare_small_triangle(const RasterPosition& a, const RasterPosition& b,
                                      const RasterPosition& c, SmallTriangle& triangle) {
  const auto area = static_cast<std::uint32_t>(-doubled_area(a, b, c));  // below 2^15
  const int zeros = std::countl_zero(area | 1u);
  const std::uint32_t inverse = detail::wide_reciprocal_mantissa(area << zeros);
  // Reduced by more than its error, so that no product with an edge function exceeds 1.
  triangle.inverse = (inverse - 16u) >> 15;
  triangle.shift = 31 - zeros;
  triangle.z = a.z;
  triangle.zb = std::int32_t{b.z} - a.z;
  triangle.zc = std::int32_t{c.z} - a.z;
  // Steps are only used where two pixels of a row are inside. There no coordinate changes by more than 1 and
  // the depth by no more than 2^16 per pixel; elsewhere they may wrap.
  const auto step = static_cast<std::int32_t>(triangle.inverse);
  triangle.db = wrap_mul(triangle.ca.dx, step) >> triangle.shift;
  triangle.dc = wrap_mul(triangle.ab.dx, step) >> triangle.shift;
  const std::int32_t across = triangle.zb * triangle.ca.dx + triangle.zc * triangle.ab.dx;
  triangle.dz = Linear::from_raw(multiply_high(wrap_shl(across >> 1, Linear::kFraction + 2 - triangle.shift),
                                               static_cast<std::int32_t>(inverse - (inverse >> 31))));
}

}  // namespace arcspan
