// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/outline/exchange.hpp>
#include <arcspan/outline/gap_list.hpp>
#include <arcspan/outline/gap_marks.hpp>
#include <arcspan/outline/gap_walk.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <span>

namespace arcspan {

namespace detail {

/// Finds the gaps of outlines in a rectangle of the picture, which is not empty. Steep edges are walked by
/// rows, flat ones by columns. Both are the same if x and y are exchanged: what is said of rows and columns
/// here is true of columns and rows then. `Gaps` is a GapList or GapMarks.
template <class Gaps>
class OutlineSmoother {
 public:
  OutlineSmoother(const Scissor& scissor, const DepthBuffer& depth, Gaps& gaps)
      : gaps_(gaps),
        depths_(depth.row(scissor.rect().top)),
        rect_(scissor.rect()),
        rows_(subpixels(rect_.top - scissor.origin().y, rect_.bottom - scissor.origin().y)),
        columns_(subpixels(rect_.left - scissor.origin().x, rect_.right - scissor.origin().x)),
        by_rows_{relative_to(scissor.origin(), rect_), depth.stride(), 1, scissor.origin(), false},
        by_columns_{exchanged(by_rows_.rect), 1, depth.stride(), exchanged(scissor.origin()), true} {}

  void smooth(const OutlineEdge& edge) {
    if (is_outside(rows_, edge.from.y, edge.to.y) || is_outside(columns_, edge.from.x, edge.to.x)) return;
    const std::int32_t dx = edge.to.x - edge.from.x;
    const std::int32_t dy = edge.to.y - edge.from.y;
    if (magnitude_of(dy) >= magnitude_of(dx)) {
      // The surface lies right of an edge that leads down.
      if (dy > 0) walk(by_rows_, edge.from, edge.to, GapPlace::kRight);
      if (dy < 0) walk(by_rows_, edge.to, edge.from, GapPlace::kLeft);
    } else if (dx > 0) {
      walk(by_columns_, exchanged(edge.from), exchanged(edge.to), GapPlace::kAbove);
    } else {
      walk(by_columns_, exchanged(edge.to), exchanged(edge.from), GapPlace::kBelow);
    }
  }

 private:
  /// How edges are walked.
  struct Direction {
    Rect rect;                ///< relative to the origin
    std::int32_t row_stride;  ///< of depths
    std::int32_t column_stride;
    RasterOrigin origin;
    bool exchanged;
  };

  /// The values that are the same for all gaps of an edge.
  struct Edge {
    const Direction& direction;
    GapPlace place;
    std::int32_t side;    ///< from a column to that of the pixel outside: -1 or 0
    std::int32_t inward;  ///< from the depth outside to that of the surface
    GapSlope slope;
  };

  ARCSPAN_OUTLINE void walk(const Direction& direction, const RasterPosition& top,
                            const RasterPosition& bottom, GapPlace place) {
    GapWalk walk(top, bottom, {direction.rect.top, direction.rect.bottom}, direction.exchanged);
    if (walk.done()) return;
    // The pixel outside is on the left if the surface is on the right, or below.
    const std::int32_t side = place == GapPlace::kRight || place == GapPlace::kBelow ? -1 : 0;
    const std::int32_t stride = direction.column_stride;
    const Edge edge{direction, place, side, side == 0 ? -stride : stride, walk.slope()};
    const std::int32_t leftmost = direction.rect.left + 1;
    const auto width = static_cast<std::uint32_t>(direction.rect.right - leftmost);
    const std::int32_t row_stride = direction.row_stride;
    std::uint16_t* row =
        depths_ + (walk.row() + direction.origin.y - (direction.exchanged ? 0 : rect_.top)) * row_stride +
        (leftmost + side + direction.origin.x - (direction.exchanged ? rect_.top : 0)) * stride;
    for (; !walk.done(); walk.next(), row += row_stride) {
      const auto column = static_cast<std::uint32_t>(walk.column() - leftmost);
      if (column >= width) continue;
      std::uint16_t* const at = row + static_cast<std::int32_t>(column) * stride;
      if (gaps_.is_hidden(*at, walk.depth())) continue;
      put(edge, walk.column(), walk.row(), walk.offset(), walk.depth(), at);
    }
  }

  /// Puts the gap left of a column. `at` is the depth of the pixel outside.
  ARCSPAN_OUTLINE void put(const Edge& edge, std::int32_t column, std::int32_t row, std::int32_t offset,
                           std::uint16_t z, std::uint16_t* at) {
    const Direction& direction = edge.direction;
    column += edge.side + direction.origin.x;
    row += direction.origin.y;
    const std::int32_t rounded = (offset + 1024) >> 11;
    const std::int32_t outward = (rounded ^ edge.side) - edge.side;
    gaps_.put(direction.exchanged ? row : column, direction.exchanged ? column : row,
              {edge.place, outward, edge.slope.corner(offset)}, z, at, at + edge.inward);
  }

  /// Coordinates of vertices.
  struct Range {
    std::int32_t least;
    std::int32_t most;
  };
  [[nodiscard]] static constexpr Range subpixels(std::int32_t first, std::int32_t end) {
    return {first * 16, end * 16};
  }
  /// True if the edge certainly has no gaps in the range.
  [[nodiscard]] ARCSPAN_INLINE static bool is_outside(const Range& range, std::int32_t a, std::int32_t b) {
    return (a < range.least && b < range.least) || (a > range.most && b > range.most);
  }

  Gaps& gaps_;
  std::uint16_t* const depths_;  ///< column 0 of the first row of the rectangle
  const Rect rect_;
  const Range rows_;
  const Range columns_;
  const Direction by_rows_;
  const Direction by_columns_;
};

template <class Gaps>
ARCSPAN_INLINE inline void find_gaps(const OutlineList& outlines, const Scissor& scissor,
                                     const DepthBuffer& depth, Gaps& gaps) {
  OutlineSmoother<Gaps> smoother(scissor, depth, gaps);
  for (const OutlineEdge& edge : outlines.edges()) smoother.smooth(edge);
}

}  // namespace detail

/// Smooths the outlines of a picture, or of a band or rectangle of one: blends each pixel that an outline
/// cuts with its neighbour on the other side, by the area on that side. Call it once, after all opaque
/// objects are drawn with `depth`, and before transparent ones. Pixels change in the common bounds of the
/// viewport and the sink, next to outlines that nothing nearer hides. Inside surfaces, and where the picture
/// shows only one side of the outline, nothing changes.
///
/// - `sink`: one whose pixels lie in memory (SinkInMemory), of at least 4 bits.
/// - `depth`: the depth buffer that the objects were drawn with. Its contents are the same afterwards.
/// - `memory`: a gap for each place where an outline passes between two pixels, at most 65535: about as many
///   as outlines have pixels. Contents before and after do not matter.
///
/// In bands the pixels are, bit for bit, those of the whole picture, if a band is drawn with one row more
/// above and below it, is smoothed with them, and is sent without them; likewise a rectangle, with one pixel
/// on all four sides. What is smoothed again, after transparent objects, takes one more each time.
///
/// Returns kOk, or the first other status of the sink, at which blending stops, or
///
///   kBufferTooSmall   `memory` was full: its gaps were blended, and it was begun anew, as often as needed.
///                     Where it was, pixels may have been blended twice. With no memory at all nothing
///                     changes.
///
/// Changes nothing and returns:
///
///   kUnsupported      the sink cannot be read, or its format has less than 4 bits per pixel
///   kDepthMismatch    `depth` does not cover the common bounds of the viewport and the sink
///   others            the status() of a Framebuffer or DepthBuffer that is not kOk
template <PixelSink Sink>
[[nodiscard]] ARCSPAN_OUTLINE Status smooth_outlines(const OutlineList& outlines, Sink& sink,
                                                     const DepthBuffer& depth,
                                                     std::span<OutlineGap<typename Sink::Format>> memory) {
  if constexpr (!SinkInMemory<Sink> || !detail::kCanBlend<typename Sink::Format>) {
    return Status::kUnsupported;
  } else {
    if (outlines.edges().empty()) return Status::kOk;
    const detail::Scissor scissor(outlines.viewport(), sink.bounds());
    const Status status = detail::check_target(scissor, sink, depth);
    if (!ok(status)) return status;
    if (scissor.rect().empty()) return Status::kOk;
    if (memory.empty()) return Status::kBufferTooSmall;
    detail::GapList<Sink> gaps(sink, depth, memory);
    detail::find_gaps(outlines, scissor, depth, gaps);
    gaps.apply();
    return gaps.status();
  }
}

/// Smooths outlines without memory: gaps are blended as they are found, and the depths of the pixels outside
/// of outlines are lost. Draw all that is tested against them first, also transparent objects, and clear
/// `depth` before the next picture. A pixel at which several outlines meet may get another mixture than with
/// memory, and another in a band than in the whole picture.
///
/// Returns kOk, or the first other status of the sink, at which blending stops; otherwise changes nothing and
/// returns kUnsupported, kDepthMismatch or the status of a Framebuffer or DepthBuffer, as above.
template <PixelSink Sink>
[[nodiscard]] ARCSPAN_OUTLINE Status smooth_outlines(const OutlineList& outlines, Sink& sink,
                                                     const DepthBuffer& depth) {
  if constexpr (!SinkInMemory<Sink> || !detail::kCanBlend<typename Sink::Format>) {
    return Status::kUnsupported;
  } else {
    if (outlines.edges().empty()) return Status::kOk;
    const detail::Scissor scissor(outlines.viewport(), sink.bounds());
    const Status status = detail::check_target(scissor, sink, depth);
    if (!ok(status) || scissor.rect().empty()) return status;
    detail::GapMarks<Sink> gaps(sink);
    detail::find_gaps(outlines, scissor, depth, gaps);
    return gaps.status();
  }
}

}  // namespace arcspan
