// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/outline/gap_list.hpp>
#include <arcspan/outline/gap_marks.hpp>
#include <arcspan/outline/gap_walk.hpp>
#include <arcspan/outline/outline_depth.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/outline/outline_way.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <span>

namespace arcspan {

namespace detail {

/// Finds the gaps of outlines in a rectangle of the picture, which is not empty. `Gaps` is a GapList or
/// GapMarks.
template <class Gaps>
class OutlineSmoother {
 public:
  OutlineSmoother(const Scissor& scissor, const DepthBuffer& depth, Gaps& gaps)
      : gaps_(gaps), rect_(scissor, depth), reach_(rect_.in_raster_units()) {}

  ARCSPAN_INLINE void smooth(const OutlineEdge& edge) {
    if (is_outside(edge)) return;
    RasterPosition top = edge.from;
    RasterPosition bottom = edge.to;
    const OutlineWay& way = rect_.way_along(top, bottom);
    GapWalk walk(top, bottom, {way.rows.first, way.rows.end}, way.columns.first + 1, way.exchanged);
    if (walk.done()) return;
    way_ = &way;
    end_ = walk.end();
    slope_ = walk.slope();
    depth_.begin(edge, way.exchanged);
    const OutlineStep step = way.columns.step;
    const auto gaps = static_cast<std::uint32_t>(way.columns.end - way.columns.first - 1);
    OutlinePixel row = way.first;
    row += way.rows.step.times(walk.skipped());
    for (; !walk.done(); walk.next(), row += way.rows.step) {
      const auto column = static_cast<std::uint32_t>(walk.column());
      if (column >= gaps) continue;
      std::uint16_t* const at = row.depth + static_cast<std::int32_t>(column) * step.depths;
      if (depth_.may_hide(*at) && !gaps_.may_be_own(*at) && depth_.is_behind(*at, end_ - walk.rows()))
        continue;
      put(at, row.column_row + column * step.column_row, walk.offset(), walk.rows());
    }
  }

 private:
  /// Puts the gap of the pixel outside of the edge, whose depth is at `at`. That depth is not nearer than the
  /// edge; one that stands elsewhere because the pixel has a gap already is tested here. `offset` and `rows`
  /// are those of the walk.
  ARCSPAN_OUTLINE void put(std::uint16_t* at, std::uint32_t pixel, std::int32_t offset, std::int32_t rows) {
    const auto outer = gaps_.outer_of(*at, pixel);
    if (gaps_.may_be_own(*at) && depth_.is_behind(outer.depth, end_ - rows)) return;
    const OutlineWay& way = *way_;
    const auto side = static_cast<std::uint32_t>(way.side);
    const std::uint32_t right = static_cast<std::uint32_t>(offset + 32768 + 1024) >> 11;
    const std::uint32_t outward = (right ^ side) + (side & 33);  // 32 - right if outside is left
    gaps_.put(pixel, {way.place, outward, slope_.corner(offset)}, outer, at, at - way.outward.depths);
  }

  /// True if an edge certainly has no gaps in the rectangle.
  [[nodiscard]] ARCSPAN_INLINE bool is_outside(const OutlineEdge& edge) const {
    const RasterPosition& a = edge.from;
    const RasterPosition& b = edge.to;
    return (a.y < reach_.top && b.y < reach_.top) || (a.y > reach_.bottom && b.y > reach_.bottom) ||
           (a.x < reach_.left && b.x < reach_.left) || (a.x > reach_.right && b.x > reach_.right);
  }

  Gaps& gaps_;
  const OutlineWay* way_ = nullptr;  ///< of the edge that is walked
  std::int32_t end_ = 0;             ///< of its rows in the rectangle
  GapSlope slope_{};
  OutlineDepth depth_;
  const OutlineRect rect_;
  const Rect reach_;
};

template <class Gaps>
ARCSPAN_INLINE inline void find_gaps(const OutlineList& outlines, const Scissor& scissor,
                                     const DepthBuffer& depth, Gaps& gaps) {
  OutlineSmoother<Gaps> smoother(scissor, depth, gaps);
  for (const OutlineEdge& edge : outlines.edges()) smoother.smooth(edge);
}

}  // namespace detail

/// Smooths the outlines of a picture, or of a band or rectangle of one: blends each pixel that an outline
/// cuts with its neighbour on the other side, by the area on that side. Call it once, after all objects
/// are drawn with `depth`; blended ones need not write it. Pixels change in the common bounds of the
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
/// on all four sides. A picture that is smoothed again takes one more.
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
