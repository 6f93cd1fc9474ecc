// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan {

/// Which pixels a triangle covers: those whose centres lie inside, or on its upper horizontal or left edges
/// (the top-left rule of GPUs). The first column of an edge is ceil(x - 1/2) on both sides, and the first row
/// of a vertex ceil(y - 1/2), which EdgeWalk::column() and first_row_at() compute exactly. What follows:
///
/// - Two triangles with a common edge cover each pixel at it once: none twice and none not at all.
/// - A closed mesh covers its outline like one polygon, whatever its triangles are.
/// - A triangle without a pixel centre inside draws nothing, however long it is.
/// - An edge depends on its two ends only: neither the order of the vertices nor the third vertex, neither
///   clipping by the guard band elsewhere nor the scissor or the band changes its columns.
/// - Moving a picture by whole pixels moves its pixels.
/// - Small triangles (small_triangle.hpp) and hardware may find the same pixels by other means.

/// Steps down an edge, one row at a time. `x` is the place where the edge crosses the row's centre line, plus
/// 1/2 - 2^-20, in pixels with 32 fraction bits; `step` is its change per row. With this bias the upper word
/// of `x` is ceil(true x - 1/2), the first column whose centre is not left of the edge, and the complement of
/// the lower word is the distance from the edge to that centre.
///
/// The column is exact. Both coordinates have 4 fraction bits and dy < 2^15, so the true x of a row is either
/// equal to the centre of a column or at least 1/(16 dy) > 2^-19 away from it. The step is too small by less
/// than 2^-32, which is less than 2^-21 over 2048 rows (decision 1).
struct EdgeWalk {
  std::int64_t x;
  std::int64_t step;

  [[nodiscard]] constexpr std::int32_t column() const { return static_cast<std::int32_t>(x >> 32); }

  /// Returns the distance from the edge to the centre of column() in pixels: 16 fraction bits, 0 or more and
  /// below 1.
  [[nodiscard]] constexpr std::uint32_t fraction() const { return ~static_cast<std::uint32_t>(x) >> 16; }

  /// Returns the distance of fraction() with 32 fraction bits and without the bias of 2^-20. It is for rows
  /// narrower than a pixel, where 16 fraction bits are too coarse.
  [[nodiscard]] constexpr std::uint32_t fine_fraction() const {
    const std::uint32_t biased = ~static_cast<std::uint32_t>(x);
    return biased < 4096u ? 0u : biased - 4096u;
  }

  ARCSPAN_INLINE constexpr void advance() { x += step; }
  /// Steps `rows` rows at once, 0...2^15 - 1; the result is that of `rows` calls of advance().
  constexpr void advance(std::int32_t rows) { x += scaled(step, static_cast<std::uint32_t>(rows)); }
};

/// The set-up of an edge that runs from its upper end `top` down to its lower end. It depends on these two
/// ends and on the first row to be drawn only, so the two triangles of an edge step down it identically.
struct EdgeSetup {
  std::int32_t dy;      ///< height in 16ths of a row, 1...2^15 - 1
  std::int32_t offset;  ///< depth of the first row's centre below the top in 16ths of a row, 0...2^15 - 1
  Reciprocal inverse;   ///< of dy
  Factor start;         ///< offset / dy, the fraction of the edge at the first row: rounded down, 0...1
};

/// Returns the first row whose centre is at or below y (28.4): ceil(y - 1/2).
[[nodiscard]] constexpr std::int32_t first_row_at(std::int32_t y) { return (y + 7) >> 4; }

/// Sets up the edge from `top` to `bottom`, where top.y < bottom.y; `row` is the first row to be drawn.
constexpr void make_edge_setup(const RasterPosition& top, const RasterPosition& bottom, std::int32_t row,
                               EdgeSetup& edge) {
  edge.dy = bottom.y - top.y;
  edge.offset = row * 16 + 8 - top.y;
  edge.inverse = nonzero_reciprocal(static_cast<std::uint32_t>(edge.dy));
  const std::uint32_t start = edge.inverse.times(static_cast<std::uint32_t>(edge.offset), Factor::kFraction);
  edge.start = Factor::from_raw(static_cast<std::int32_t>(start > 32768 ? 32768 : start));
}

/// Sets `walk` to the edge at its first row; `top` and `bottom` are the ends that `edge` was set up with.
constexpr void make_edge_walk(const EdgeSetup& edge, const RasterPosition& top, const RasterPosition& bottom,
                              EdgeWalk& walk) {
  const std::int32_t dx = bottom.x - top.x;
  walk.step = kHasLongMultiply ? detail::divide(dx, edge.dy)
                               : detail::divide_by_reciprocal(dx, edge.dy, edge.inverse);
  // 1/2 - 2^-20 in 16ths of a pixel, as all terms of the sum are.
  constexpr std::int64_t kBias = (std::int64_t{1} << 35) - (std::int64_t{1} << 16);
  walk.x =
      (scaled(walk.step, static_cast<std::uint32_t>(edge.offset)) + (std::int64_t{top.x} << 32) + kBias) >> 4;
}

}  // namespace arcspan
