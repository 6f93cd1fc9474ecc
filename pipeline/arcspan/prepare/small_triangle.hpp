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
inline constexpr std::int32_t kSmallSize = 8;

/// Returns true if the triangle is small.
[[nodiscard]] constexpr bool is_small(const RasterPosition& a, const RasterPosition& b,
                                      const RasterPosition& c) {
  constexpr std::int32_t kMost = kSmallSize << Subpixel::kFraction;
  const auto apart = [](std::int32_t p, std::int32_t q) {
    return static_cast<std::uint32_t>(p - q + kMost) > 2 * static_cast<std::uint32_t>(kMost);
  };
  if (apart(a.x, b.x) || apart(a.y, b.y)) return false;
  return !(apart(a.x, c.x) || apart(b.x, c.x) || apart(a.y, c.y) || apart(b.y, c.y));
}

/// The edge function of an edge: twice the area of the triangle between the edge and a point, in 256ths of a
/// square pixel, positive inside. All values are exact: below 2^16 in magnitude within the box of a small
/// triangle.
struct EdgeFunction {
  std::int32_t at;   ///< at the centre of the box's first pixel
  std::int32_t dx;   ///< change per pixel
  std::int32_t dy;   ///< change per row
  std::int32_t tie;  ///< added before the test for >= 0: -1 if a pixel centre on the edge is outside, else 0

  /// Returns a number that is negative if the point where the function is `value` is outside.
  [[nodiscard]] constexpr std::int32_t outside(std::int32_t value) const { return value + tie; }
};

/// The pixels of a small triangle in a row: columns first ... first + count - 1 of the box.
struct SmallSpan {
  std::uint8_t first;
  std::uint8_t count;
};

/// What the span stage needs of a small triangle besides its shading. It consists of integers, like a
/// TriangleCommand, which docs/triangle-command.md describes.
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
  EdgeFunction bc;
  EdgeFunction ca;
  /// 2^16 / (twice the area in 256ths of a square pixel) = inverse * 2^-shift, rounded down.
  std::uint32_t inverse;
  int shift;
  std::int32_t z;   ///< depth of vertex a
  std::int32_t zb;  ///< what vertex b is deeper
  std::int32_t zc;
  SmallSpan spans[kSmallSize];

  /// Returns a barycentric coordinate from its edge function at a point inside: 16 fraction bits, rounded
  /// down, so that the sum of all three is at most 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t coordinate(std::int32_t value) const {
    return static_cast<std::int32_t>((static_cast<std::uint32_t>(value) * inverse) >> shift);
  }
  /// Returns the depth at the barycentric coordinates b and c. It is within 7 of the plane through the
  /// vertices and never outside of their depths.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::uint16_t depth(std::int32_t b, std::int32_t c) const {
    const std::int32_t part = wrap_add(wrap_mul(zb, b >> 1), wrap_mul(zc, c >> 1));
    return static_cast<std::uint16_t>(z + (part >> 15));
  }
};

namespace detail {

/// Makes the edge function of the edge from p to q, inside being on the left as seen on the screen (y down).
/// A centre on a left edge or on a top edge is inside.
constexpr void make_edge_function(const RasterPosition& p, const RasterPosition& q,
                                  const SmallTriangle& triangle, EdgeFunction& edge) {
  const std::int32_t dx = q.x - p.x;
  const std::int32_t dy = q.y - p.y;
  const std::int32_t x = triangle.column * 16 + 8 - p.x;
  const std::int32_t y = triangle.row * 16 + 8 - p.y;
  edge.at = dy * x - dx * y;
  edge.dx = dy * 16;
  edge.dy = dx * -16;
  edge.tie = dy > 0 || (dy == 0 && dx < 0) ? 0 : -1;
}

/// Finds the pixels of every row. Returns false if there are none.
[[nodiscard]] constexpr bool find_spans(SmallTriangle& triangle) {
  std::int32_t ab = triangle.ab.outside(triangle.ab.at);
  std::int32_t bc = triangle.bc.outside(triangle.bc.at);
  std::int32_t ca = triangle.ca.outside(triangle.ca.at);
  const std::int32_t ab_dx = triangle.ab.dx;
  const std::int32_t bc_dx = triangle.bc.dx;
  const std::int32_t ca_dx = triangle.ca.dx;
  std::uint32_t found = 0;
  for (std::int32_t row = 0; row < triangle.rows; ++row) {
    std::int32_t u = ab;
    std::int32_t v = bc;
    std::int32_t w = ca;
    std::int32_t left = triangle.columns;
    for (; left != 0 && (u | v | w) < 0; --left) {
      u += ab_dx;
      v += bc_dx;
      w += ca_dx;
    }
    const std::int32_t outside = left;
    for (; left != 0 && (u | v | w) >= 0; --left) {
      u += ab_dx;
      v += bc_dx;
      w += ca_dx;
    }
    triangle.spans[row] = {static_cast<std::uint8_t>(triangle.columns - outside),
                           static_cast<std::uint8_t>(outside - left)};
    found |= static_cast<std::uint32_t>(outside - left);
    ab += triangle.ab.dy;
    bc += triangle.bc.dy;
    ca += triangle.ca.dy;
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
  detail::make_edge_function(a, b, triangle, triangle.ab);
  detail::make_edge_function(b, c, triangle, triangle.bc);
  detail::make_edge_function(c, a, triangle, triangle.ca);
  return detail::find_spans(triangle);
}

/// Prepares the barycentric coordinates and the depth of a small triangle with pixels.
constexpr void prepare_small_triangle(const RasterPosition& a, const RasterPosition& b,
                                      const RasterPosition& c, SmallTriangle& triangle) {
  const auto area = static_cast<std::uint32_t>(-doubled_area(a, b, c));  // below 2^15
  const int zeros = std::countl_zero(area | 1u);
  // Reduced by more than its error, so that no product with an edge function exceeds 1.
  triangle.inverse = (detail::wide_reciprocal_mantissa(area << zeros) - 16u) >> 15;
  triangle.shift = 31 - zeros;
  triangle.z = a.z;
  triangle.zb = std::int32_t{b.z} - a.z;
  triangle.zc = std::int32_t{c.z} - a.z;
}

}  // namespace arcspan
