// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/outline/gap_list.hpp>
#include <arcspan/outline/gap_walk.hpp>
#include <arcspan/outline/outline_edges.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>
#include <span>

namespace arcspan {

namespace detail {

/// Finds the gaps of outlines in a rectangle of the picture.
template <PixelSink Sink>
class OutlineSmoother {
 public:
  OutlineSmoother(const Scissor& scissor, GapList<Sink>& gaps)
      : origin_(scissor.origin()), rect_(scissor.rect()), gaps_(gaps) {}

  void smooth(const OutlineEdge& edge) {
    const std::int32_t dx = edge.to.x - edge.from.x;
    const std::int32_t dy = edge.to.y - edge.from.y;
    if (magnitude(dy) >= magnitude(dx)) {
      // The surface lies right of an edge that leads down.
      if (dy > 0) walk_rows(edge.from, edge.to, GapPlace::kRight);
      if (dy < 0) walk_rows(edge.to, edge.from, GapPlace::kLeft);
    } else if (dx > 0) {
      walk_columns(edge.from, edge.to, GapPlace::kAbove);
    } else {
      walk_columns(edge.to, edge.from, GapPlace::kBelow);
    }
  }

 private:
  [[nodiscard]] static constexpr std::int32_t magnitude(std::int32_t v) { return v < 0 ? -v : v; }
  [[nodiscard]] static constexpr RasterPosition exchanged(const RasterPosition& p) { return {p.y, p.x, p.z}; }

  ARCSPAN_OUTLINE void walk_rows(const RasterPosition& top, const RasterPosition& bottom, GapPlace place) {
    GapWalk walk(top, bottom, {rect_.top - origin_.y, rect_.bottom - origin_.y}, false);
    for (; !walk.done(); walk.next()) {
      const std::int32_t column = walk.column() + origin_.x;
      if (column <= rect_.left || column >= rect_.right) continue;
      put(walk, place == GapPlace::kRight ? column - 1 : column, walk.row() + origin_.y, place,
          place == GapPlace::kLeft);
    }
  }

  ARCSPAN_OUTLINE void walk_columns(const RasterPosition& left, const RasterPosition& right, GapPlace place) {
    if (is_outside_rows(left, right)) return;
    GapWalk walk(exchanged(left), exchanged(right), {rect_.left - origin_.x, rect_.right - origin_.x}, true);
    for (; !walk.done(); walk.next()) {
      const std::int32_t row = walk.column() + origin_.y;
      if (row <= rect_.top || row >= rect_.bottom) continue;
      put(walk, walk.row() + origin_.x, place == GapPlace::kBelow ? row - 1 : row, place,
          place == GapPlace::kAbove);
    }
  }

  /// True if no row of the edge has a row of the rectangle above and below it.
  [[nodiscard]] bool is_outside_rows(const RasterPosition& a, const RasterPosition& b) const {
    const std::int32_t top = (rect_.top - origin_.y) * 16;
    const std::int32_t bottom = (rect_.bottom - origin_.y) * 16;
    return (a.y < top && b.y < top) || (a.y > bottom && b.y > bottom);
  }

  /// `forward`: the pixel outside is the one of the greater column or row.
  ARCSPAN_INLINE void put(const GapWalk& walk, std::int32_t x, std::int32_t y, GapPlace place, bool forward) {
    const std::int32_t offset = walk.offset();
    const std::int32_t rounded = (offset + 1024) >> 11;
    gaps_.put(x, y, {place, forward ? rounded : -rounded, walk.corner(offset)}, walk.depth());
  }

  const RasterOrigin origin_;
  const Rect rect_;
  GapList<Sink>& gaps_;
};

}  // namespace detail

/// Smooths the outlines of a picture, or of a band or rectangle of one: blends each pixel that an outline cuts
/// with its neighbour on the other side, by the area on that side. Call it once, after all opaque objects are
/// drawn with `depth`, and before transparent ones. Pixels change in the common bounds of the viewport and the
/// sink, next to outlines that nothing nearer hides. Inside surfaces, and where the picture shows only one
/// side of the outline, nothing changes.
///
/// - `sink`: one whose pixels lie in memory (SinkInMemory), of at least 4 bits.
/// - `depth`: the depth buffer that the objects were drawn with. Its contents are the same afterwards.
/// - `memory`: a gap for each place where an outline passes between two pixels, at most 65535: about as many
///   as outlines have pixels. Contents before and after do not matter.
///
/// In bands the pixels are, bit for bit, those of the whole picture, if a band is drawn with one row more above
/// and below it, is smoothed with them, and is sent without them; likewise a rectangle, with one pixel on all
/// four sides.
///
/// Returns kOk, or the first other status of the sink, at which blending stops, or
///
///   kBufferTooSmall   `memory` was full: its gaps were blended, and it was begun anew, as often as needed.
///                     Where it was, pixels may have been blended twice. With no memory at all nothing changes.
///
/// Changes nothing and returns:
///
///   kUnsupported      the sink cannot be read, or its format has less than 4 bits per pixel
///   kDepthMismatch    `depth` does not cover the common bounds of the viewport and the sink
///   others            the status() of a Framebuffer or DepthBuffer that is not kOk
template <PixelSink Sink>
[[nodiscard]] ARCSPAN_OUTLINE Status smooth_outlines(const OutlineEdges& outlines, Sink& sink,
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
    detail::OutlineSmoother<Sink> smoother(scissor, gaps);
    for (const OutlineEdge& edge : outlines.edges()) smoother.smooth(edge);
    gaps.apply();
    return gaps.status();
  }
}

}  // namespace arcspan
