// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <type_traits>

/// Triangles of a few pixels. Setting up edges, planes and rows for them would take most of their time, so
/// the columns of a row are stepped down the edges, and everything that is interpolated starts in each row
/// from the barycentric coordinates of its first pixel (decision 35).
namespace arcspan {

/// Vertices of small triangles are at most this many pixels apart, along x and along y.
inline constexpr std::int32_t kSmallSize = 32;
/// Twice the largest area of a small triangle, 96 square pixels, in 256ths. Larger ones are drawn faster by
/// edges, on Armv6-M above all.
inline constexpr std::uint32_t kSmallDoubledArea = std::uint32_t{2} * 96 * 256;

/// Method::kSmallSize, 16 or 32, of a method that has it, otherwise kSmallSize.
template <class Method>
[[nodiscard]] consteval std::int32_t small_size() {
  if constexpr (requires { Method::kSmallSize; }) return Method::kSmallSize;
  return kSmallSize;
}

/// Returns true if the triangle is small: its vertices are at most small_size() pixels apart, and if they may
/// be more than 16 pixels apart, its area is that of a small triangle.
template <class Method>
[[nodiscard]] constexpr bool is_small(const SortedVertices<Method>& vertices) {
  const RasterPosition& a = vertices.top->position;
  const RasterPosition& b = vertices.middle->position;
  const RasterPosition& c = vertices.bottom->position;
  constexpr std::int32_t kFits = 16 << Subpixel::kFraction;  // whatever the area
  constexpr std::int32_t kMost = small_size<Method>() << Subpixel::kFraction;
  // d, or -d - 1 where d is negative: all are below a power of two if their bits together are.
  const auto apart = [](std::int32_t p, std::int32_t q) { return (p - q) ^ ((p - q) >> 31); };
  const std::int32_t size = apart(a.x, b.x) | apart(a.x, c.x) | apart(b.x, c.x) | (c.y - a.y);
  return size < kFits ||
         (kMost > kFits && size < kMost && magnitude(doubled_area(a, b, c)) < kSmallDoubledArea);
}

/// The edge function of an edge: twice the area of the triangle between the edge and a point, in 256ths of a
/// square pixel, of the sign of doubled_area() inside. All values are exact, and those inside of the triangle
/// below 2^16 in magnitude.
struct EdgeFunction {
  std::int32_t at;  ///< at the centre of column 0 in the first row
  std::int32_t dx;  ///< change per pixel
  std::int32_t dy;  ///< change per row

  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t operator()(std::int32_t column,
                                                                 std::int32_t row) const {
    return at + column * dx + row * dy;
  }
};

/// The pixels of a small triangle in a row: columns first ... first + count - 1, relative to the raster
/// origin.
struct SmallSpan {
  std::int16_t first;
  std::int16_t count;
};

/// The command of a small triangle for the span stage, without its shading. It consists of integers, like a
/// TriangleCommand; docs/triangle-command.md describes both. Its vertices are sorted by height.
struct SmallTriangle {
  std::int32_t row;  ///< the first row to be drawn, relative to the raster origin
  std::int32_t rows;
  EdgeFunction of_middle;  ///< of the edge opposite to the middle vertex
  EdgeFunction of_bottom;
  /// 2^16 / (twice the area in 256ths of a square pixel) = inverse * 2^-shift, rounded down; negative like
  /// the edge functions where the middle vertex is on the left.
  std::int32_t inverse;
  int shift;
  /// Changes of the coordinates of the middle and the bottom vertex per pixel, times twice the area as it is
  /// scaled to 2^13...2^14: below 2^14 in magnitude where two pixels of a row are inside.
  std::int32_t steep_middle;
  std::int32_t steep_bottom;
  std::int32_t z;         ///< depth of the top vertex
  std::int32_t z_middle;  ///< depth of the middle vertex less that of the top vertex
  std::int32_t z_bottom;
  Linear dz;  ///< change of the depth per pixel
  SmallSpan spans[kSmallSize];
  /// The pixels of rows that begin left of what is drawn. Set by hide_columns() only.
  std::int8_t cut_counts[kSmallSize];

  /// Returns a barycentric coordinate from its edge function at a point inside: 16 fraction bits, rounded
  /// down, so that the sum of all three is at most 1.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t coordinate(std::int32_t value) const {
    return static_cast<std::int32_t>(
        (static_cast<std::uint32_t>(value) * static_cast<std::uint32_t>(inverse)) >> shift);
  }
  /// Return the changes of coordinates per pixel, 16 fraction bits, rounded; in slivers, too.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t d_middle() const {
    return coordinate_step(of_middle.dx);
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t d_bottom() const {
    return coordinate_step(of_bottom.dx);
  }
  /// Fraction bits that per_pixel() adds.
  static constexpr int kStepBits = 12;
  /// Returns the change per pixel of what is by these larger at the middle and at the bottom vertex than at
  /// the top one, for triangles with two pixels in a row, where it is below 2^16 without its kStepBits. It is
  /// off by 2^-15 of itself and one unit: over a row by 2^-15 of the change along it and 32 units.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t per_pixel(std::int32_t to_middle,
                                                                std::int32_t to_bottom) const {
    const std::int32_t sum = wrap_add(wrap_mul(to_middle, steep_middle), wrap_mul(to_bottom, steep_bottom));
    // Both give the same bits where steps are used.
    if constexpr (kHasLongMultiply) return multiply_high(sum, wrap_shl(inverse, 15));
    return wrap_add(wrap_mul(sum >> 15, inverse), wrap_mul(sum & 0x7FFF, inverse) >> 15) >> 2;
  }
  /// Returns the depth at the coordinates of the middle and of the bottom vertex. It is within 7 steps of
  /// depth of the plane through the vertices and never outside of their depths.
  [[nodiscard]] ARCSPAN_INLINE constexpr Linear depth(std::int32_t middle, std::int32_t bottom) const {
    const std::int32_t part =
        wrap_add(wrap_mul(z_middle, middle >> 1), wrap_mul(z_bottom, bottom >> 1));  // 15 fraction bits
    return Linear::from_raw((z << Linear::kFraction) + (part >> (15 - Linear::kFraction)));
  }

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t coordinate_step(std::int32_t dx) const {
    return wrap_add(wrap_mul(dx, inverse), (std::int32_t{1} << shift) >> 1) >> shift;
  }
};

namespace detail {

/// The first column right of an edge, or with its centre on it, from row to row: the first pixel of a row if
/// the edge is on the left, and the one behind the last if it is on the right (top-left rule). It is exact.
///
/// Where an edge meets a row's centre line is a multiple of 1 / (16 dy) of a pixel, at least 2^-13. at_ is
/// too small by more than 0 and by less than that, so its floor is exact: the step is rounded to 0, so that
/// kSmallSize rows of it are off by less than that many units in either direction.
class SteppedColumn {
 public:
  /// The edge from p down to q, at the row whose centre line is at `y` (28.4).
  ARCSPAN_INLINE constexpr SteppedColumn(const RasterPosition& p, const RasterPosition& q, std::int32_t y)
      : step_(((q.x - p.x) * kOne) / (q.y - p.y)),
        at_((p.x + 8) * (kOne >> 4) + (((y - p.y) * step_) >> 4) - (kSmallSize + 1)) {}
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t column() const { return at_ >> kFraction; }
  ARCSPAN_INLINE constexpr void advance() { at_ += step_; }

 private:
  static constexpr int kFraction = 20;
  static constexpr std::int32_t kOne = std::int32_t{1} << kFraction;

  std::int32_t step_;  ///< change per row in pixels, 20 fraction bits
  std::int32_t at_;    ///< half a pixel right of the edge, 20 fraction bits
};

/// SteppedColumn without a division: the edge function is kept at the centre of the column, and the column
/// moves until the value is that of the first one right of the edge.
class SettledColumn {
 public:
  ARCSPAN_INLINE constexpr SettledColumn(const RasterPosition& p, const RasterPosition& q, std::int32_t y)
      : column_((p.x + 7) >> Subpixel::kFraction) {
    const std::int32_t dx = q.x - p.x;
    const std::int32_t dy = q.y - p.y;
    value_ = (column_ * 16 + 8 - p.x) * dy - (y - p.y) * dx;
    per_column_ = dy * 16;
    per_row_ = dx * 16;
    settle();
  }
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t column() const { return column_; }
  ARCSPAN_INLINE constexpr void advance() {
    value_ -= per_row_;
    settle();
  }

 private:
  ARCSPAN_INLINE constexpr void settle() {
    for (; value_ < 0; value_ += per_column_) ++column_;
    for (; value_ >= per_column_; value_ -= per_column_) --column_;
  }

  std::int32_t column_;
  std::int32_t value_;  ///< edge function at the column's centre, at least 0, less than per_column_
  std::int32_t per_column_;
  std::int32_t per_row_;
};

using EdgeColumn = std::conditional_t<kHasLongMultiply, SteppedColumn, SettledColumn>;

/// Finds the pixels of the rows from `span` to `end`, at least one, between two edges. Leaves the edges at
/// the last row. Returns 0 if there are none.
[[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t find_spans(EdgeColumn& left, EdgeColumn& right,
                                                               SmallSpan* span, const SmallSpan* end) {
  std::int32_t found = 0;
  while (true) {
    const std::int32_t count = right.column() - left.column();
    span->first = static_cast<std::int16_t>(left.column());
    hide_value(span);  // otherwise gcc merges both stores on RISC-V, which takes five more instructions
    span->count = static_cast<std::int16_t>(count);
    found |= count;
    if (++span == end) return found;
    left.advance();
    right.advance();
  }
}

}  // namespace detail

/// Finds the pixels of a small triangle in the rows of `limits`. The vertices are sorted by height, and the
/// middle one is on the left of the long edge where `middle_left` is true. Returns false, with `triangle`
/// partly set, if there are none. The same pixels are found as by TriangleCommand.
[[nodiscard]] ARCSPAN_INLINE constexpr bool cover_small_triangle(const RasterPosition& top,
                                                                 const RasterPosition& middle,
                                                                 const RasterPosition& bottom,
                                                                 bool middle_left, const RowRange& limits,
                                                                 SmallTriangle& triangle) {
  const std::int32_t first_row = first_row_at(top.y);
  const std::int32_t end_row = first_row_at(bottom.y);
  const std::int32_t first = first_row > limits.first ? first_row : limits.first;
  const std::int32_t end = end_row < limits.end ? end_row : limits.end;
  triangle.row = first;
  triangle.rows = end - first;
  if (first >= end) return false;
  const std::int32_t half = first_row_at(middle.y);
  const bool has_upper = first < half;
  const std::int32_t y = first * 16 + 8;
  const RasterPosition& short_top = has_upper ? top : middle;
  const RasterPosition& short_bottom = has_upper ? middle : bottom;
  detail::EdgeColumn left(top, bottom, y);
  detail::EdgeColumn right(short_top, short_bottom, y);
  if (middle_left) {
    const detail::EdgeColumn long_edge = left;
    left = right;
    right = long_edge;
  }
  SmallSpan* span = triangle.spans;
  const SmallSpan* const last = span + triangle.rows;
  std::int32_t found = 0;
  if (has_upper && half < end) {
    found = detail::find_spans(left, right, span, span + (half - first));
    span += half - first;
    const detail::EdgeColumn lower(middle, bottom, half * 16 + 8);
    if (middle_left) {
      left = lower;
      right.advance();
    } else {
      left.advance();
      right = lower;
    }
  }
  return (found | detail::find_spans(left, right, span, last)) != 0;
}

/// Cuts the spans of a triangle to the columns left ... right - 1, relative to the raster origin. Returns
/// false if no pixel is left.
[[nodiscard]] constexpr bool cut_columns(std::int32_t left, std::int32_t right, SmallTriangle& triangle) {
  std::int32_t found = 0;
  for (SmallSpan* span = triangle.spans; span != triangle.spans + triangle.rows; ++span) {
    const std::int32_t end = span->first + span->count;
    const std::int32_t first = span->first > left ? span->first : left;
    const std::int32_t count = (end < right ? end : right) - first;
    span->first = static_cast<std::int16_t>(first);
    span->count = static_cast<std::int16_t>(count > 0 ? count : 0);
    found |= span->count;
  }
  return found != 0;
}

/// Leaves out the pixels of a triangle that are left of a column. Rows that begin there get the count 0 and
/// cut_counts, because their runs start at `first` nevertheless.
constexpr void hide_columns(std::int32_t left, SmallTriangle& triangle) {
  for (std::int32_t row = 0; row < triangle.rows; ++row) {
    SmallSpan& span = triangle.spans[row];
    const std::int32_t count = span.first < left ? span.first + span.count - left : 0;
    triangle.cut_counts[row] = static_cast<std::int8_t>(count > 0 ? count : 0);
    if (span.first < left) span.count = 0;
  }
}

/// Prepares the barycentric coordinates and the depth of a small triangle with pixels. The vertices are
/// sorted by height.
constexpr void prepare_small_triangle(const RasterPosition& top, const RasterPosition& middle,
                                      const RasterPosition& bottom, SmallTriangle& triangle) {
  const std::int32_t left = 8 - top.x;
  const std::int32_t above = triangle.row * 16 + 8 - top.y;
  const std::int32_t dx = bottom.x - top.x;
  const std::int32_t dy = bottom.y - top.y;
  const std::int32_t short_dx = middle.x - top.x;
  const std::int32_t short_dy = middle.y - top.y;
  const std::int32_t area = short_dx * dy - dx * short_dy;  // doubled_area()
  triangle.of_middle = {dy * left - dx * above, dy * 16, dx * -16};
  triangle.of_bottom = {short_dx * above - short_dy * left, short_dy * -16, short_dx * 16};
  const std::uint32_t size = magnitude(area);  // below 2^16
  const int zeros = leading_zeros(size | 1u);
  const std::uint32_t wide = detail::wide_reciprocal_mantissa(size << zeros);
  // Reduced by more than its error, so that no product with an edge function exceeds 1.
  const auto narrow = static_cast<std::int32_t>((wide - 16u) >> 15);
  triangle.inverse = area < 0 ? -narrow : narrow;
  triangle.shift = 31 - zeros;
  triangle.z = top.z;
  triangle.z_middle = std::int32_t{middle.z} - top.z;
  triangle.z_bottom = std::int32_t{bottom.z} - top.z;
  // Steps are only used where two pixels of a row are inside. There no coordinate changes by more than 1 per
  // pixel; elsewhere per_pixel() may wrap.
  triangle.steep_middle = wrap_shl(dy, 17 - triangle.shift);
  triangle.steep_bottom = wrap_shl(-short_dy, 17 - triangle.shift);
  triangle.dz = Linear::from_raw(triangle.per_pixel(triangle.z_middle, triangle.z_bottom));
}

}  // namespace arcspan
