// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/outline/exchange.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>
#include <utility>

namespace arcspan::detail {

/// A step from a pixel to a neighbour.
struct OutlineStep {
  std::int32_t depths;       ///< elements of the depth buffer
  std::uint32_t column_row;  ///< what OutlinePixel::column_row changes by, modulo 2^32

  [[nodiscard]] ARCSPAN_INLINE constexpr OutlineStep times(std::int32_t n) const {
    return {depths * n, column_row * static_cast<std::uint32_t>(n)};
  }
};

/// A pixel of the picture: column and row in one word, and where its depth is.
struct OutlinePixel {
  std::uint32_t column_row;  ///< x in the lower half, y in the upper
  std::uint16_t* depth;

  [[nodiscard]] constexpr std::int32_t x() const { return static_cast<std::int32_t>(column_row & 0xFFFFu); }
  [[nodiscard]] constexpr std::int32_t y() const { return static_cast<std::int32_t>(column_row >> 16); }

  ARCSPAN_INLINE constexpr void operator+=(const OutlineStep& step) {
    column_row += step.column_row;
    depth += step.depths;
  }
};

/// Columns or rows first ... end - 1 of a rectangle, relative to the raster origin.
struct OutlineAxis {
  std::int32_t first;
  std::int32_t end;
  OutlineStep step;  ///< from one to the next
};

/// How edges are walked in a rectangle: from top to bottom, row by row. Flat edges are walked with x and y
/// exchanged: for them read "row" as "column" and "left" as "above". In a gap between two pixels the inner
/// pixel is on the surface, the outer one beside it.
struct OutlineWay {
  OutlineAxis rows;
  OutlineAxis columns;
  OutlinePixel first;   ///< of the first two pixels of the first row, the outer one
  OutlineStep outward;  ///< from the inner pixel to the outer one
  std::int32_t side;    ///< -1 if the outer pixel is left of the edge, 0 if it is right
  GapPlace place;       ///< of the inner pixel, as seen from the outer one
  bool exchanged;       ///< the edge is flat
};

/// The part of the picture in which edges are walked; not empty.
class OutlineRect {
 public:
  OutlineRect(const Scissor& scissor, const DepthBuffer& depth) {
    const Rect& r = scissor.rect();
    const Rect inside = relative_to(scissor.origin(), r);
    const OutlineAxis axes[] = {{inside.top, inside.bottom, {depth.stride(), std::uint32_t{1} << 16}},
                                {inside.left, inside.right, {1, 1}}};
    const OutlinePixel first{static_cast<std::uint32_t>(r.top) << 16 | static_cast<std::uint32_t>(r.left),
                             depth.row(r.top) + r.left};
    // The surface lies right of an edge that leads down, left of one that leads up, above one that leads to
    // the right and below one that leads to the left.
    for (std::int32_t i = 0; i < 4; ++i) {
      OutlineWay& way = ways_[i];
      const std::int32_t place = i ^ (i >> 1);
      const std::int32_t outside = place & 1;  // the outer pixel is right of the edge, or below
      way.rows = axes[i >> 1];
      way.columns = axes[1 - (i >> 1)];
      way.first = first;
      way.first += way.columns.step.times(outside);
      way.outward = way.columns.step.times(2 * outside - 1);
      way.side = outside - 1;
      way.place = static_cast<GapPlace>(place);
      way.exchanged = i >= 2;
    }
  }

  /// Its sides in units of RasterPosition.
  [[nodiscard]] Rect in_raster_units() const {
    const OutlineAxis& rows = ways_[0].rows;
    const OutlineAxis& columns = ways_[0].columns;
    return {columns.first * 16, rows.first * 16, columns.end * 16, rows.end * 16};
  }

  /// The way of an edge. Exchanges x and y of its ends if it is flat, then the ends if `bottom` is above.
  ARCSPAN_INLINE const OutlineWay& way_along(RasterPosition& top, RasterPosition& bottom) const {
    const OutlineWay* way = ways_;
    if (magnitude(std::int32_t{bottom.y} - top.y) < magnitude(std::int32_t{bottom.x} - top.x)) {
      top = exchanged(top);
      bottom = exchanged(bottom);
      way += 2;
    }
    if (bottom.y < top.y) {
      std::swap(top, bottom);
      ++way;
    }
    return *way;
  }

 private:
  OutlineWay ways_[4];  ///< of edges that lead down, up, to the right, to the left
};

}  // namespace arcspan::detail
