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

/// The way from a pixel to a neighbour.
struct OutlineStep {
  std::int32_t depths;
  std::uint32_t column_row;

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

/// The columns or rows of a rectangle, relative to the origin.
struct OutlineAxis {
  std::int32_t first;
  std::int32_t end;
  OutlineStep step;  ///< from one to the next
};

/// How edges are walked in a rectangle: from top to bottom, steep ones by rows, flat ones by columns. What is
/// said of rows and columns here is true of columns and rows then.
struct OutlineWay {
  OutlineAxis rows;
  OutlineAxis columns;
  OutlinePixel first;   ///< in the first row, the pixel outside if an edge lies between the first two columns
  OutlineStep outward;  ///< from the pixel inside to the one outside
  std::int32_t side;    ///< on which side of the edge the surface is not: left (-1) or right (0)
  GapPlace place;
  bool exchanged;  ///< x and y are
};

/// A rectangle of the picture, which is not empty, in which edges are walked.
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
      const std::int32_t outside = place & 1;  // is right of the edge
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

  [[nodiscard]] const OutlineAxis& rows() const { return ways_[0].rows; }
  [[nodiscard]] const OutlineAxis& columns() const { return ways_[0].columns; }

  /// The way along an edge. Puts its ends in order, and exchanges their x and y if it is walked so.
  ARCSPAN_INLINE const OutlineWay& way_along(RasterPosition& top, RasterPosition& bottom) const {
    const OutlineWay* way = ways_;
    if (magnitude_of(bottom.y - top.y) < magnitude_of(bottom.x - top.x)) {
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
  OutlineWay ways_[4];  ///< down and up, to the right and to the left
};

}  // namespace arcspan::detail
