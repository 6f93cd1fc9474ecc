// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/draw/scissor.hpp>
#include <arcspan/outline/ink_pixels.hpp>
#include <arcspan/outline/ink_walk.hpp>
#include <arcspan/outline/outline_depth.hpp>
#include <arcspan/outline/outline_gap.hpp>
#include <arcspan/outline/outline_list.hpp>
#include <arcspan/outline/outline_way.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan {

/// How outlines are inked.
struct OutlineInk {
  static constexpr std::uint8_t kWidest = 4;

  Rgb8 colour{};
  std::uint8_t width = 1;  ///< of outlines: 1...kWidest pixels, outside of the surface
  bool creases = true;     ///< creases are inked too, by lines of one pixel
};

namespace detail {

/// Inks outlines in a rectangle of the picture, which is not empty. `Pixels` is InkPixels.
template <class Pixels>
class OutlineInker {
 public:
  OutlineInker(const Scissor& scissor, const DepthBuffer& depth, std::int32_t width, Pixels& pixels)
      : pixels_(pixels), width_(width), rect_(scissor, depth) {}

  /// Inks the side of an edge on which the surface is not.
  void ink_outline(const OutlineEdge& edge) {
    RasterPosition top = edge.from;
    RasterPosition bottom = edge.to;
    const OutlineWay& way = rect_.way_along(top, bottom);
    if (is_outside(way, top, bottom)) return;
    InkWalk walk(top, bottom, {way.rows.first, way.rows.end}, way.exchanged, way.side, width_);
    if (walk.done()) return;
    begin(edge, way);
    OutlinePixel row = way.first;
    row += way.rows.step.times(walk.row() - way.rows.first);
    for (; !walk.done(); walk.next(), row += way.rows.step) {
      const std::int32_t reach = walk.reach() + kHalfShare;
      if (reach >= 2 * kHalfShare) ink_row(row, walk.column() - way.columns.first, reach, walk.row());
    }
  }
  /// Inks both sides of an edge, half a pixel of each.
  void ink_crease(const OutlineEdge& edge) {
    RasterPosition top = edge.from;
    RasterPosition bottom = edge.to;
    const OutlineWay& way = rect_.way_along(top, bottom);
    if (is_outside(way, top, bottom)) return;
    begin(edge, way);
    ink_middle(top, bottom);
  }

 private:
  /// The share in 32nds of a pixel that ink covers as far as `reach` and half a share less, with 16 fraction
  /// bits.
  [[nodiscard]] ARCSPAN_INLINE static std::uint32_t share_of(std::int32_t reach) {
    return reach >= 65536 ? Pixels::kWhole : static_cast<std::uint32_t>(reach) / (2 * kHalfShare);
  }

  void begin(const OutlineEdge& edge, const OutlineWay& way) {
    way_ = &way;
    depth_.begin(edge, way.exchanged);
  }

  /// Inks a row outward from the edge. `at` is OutlineWay::first moved to this row, `column` the walk's,
  /// counted from the first one of the rectangle, and `reach` how far the ink goes, as share_of() takes it.
  ARCSPAN_INLINE void ink_row(OutlinePixel at, std::int32_t column, std::int32_t reach, std::int32_t row) {
    const OutlineWay& way = *way_;
    const OutlineStep outward = way.outward;
    const std::int32_t sign = 2 * way.side + 1;
    const auto columns = static_cast<std::uint32_t>(way.columns.end - way.columns.first);
    at += way.columns.step.times(column - 1);
    auto outer = static_cast<std::uint32_t>(column + way.side);
    do {
      if (outer < columns && is_free(at, row)) pixels_.put(at, share_of(reach));
      outer += static_cast<std::uint32_t>(sign);
      at += outward;
      reach -= 65536;
    } while (reach >= 2 * kHalfShare);
  }

  /// True if nothing nearer than the edge in this row is drawn at a pixel.
  [[nodiscard]] ARCSPAN_INLINE bool is_free(const OutlinePixel& at, std::int32_t row) const {
    return !depth_.is_behind(pixels_.depth_of(at), row);
  }

  /// The pixels on both sides, if one is free, by their nearness to the edge.
  ARCSPAN_OUTLINE void ink_middle(const RasterPosition& top, const RasterPosition& bottom) {
    const OutlineWay& way = *way_;
    InkWalk walk(top, bottom, {way.rows.first, way.rows.end}, way.exchanged, 0, 0);
    for (; !walk.done(); walk.next()) {
      const std::int32_t column = walk.column() - way.columns.first;
      if (column <= 0 || column >= way.columns.end - way.columns.first) continue;
      OutlinePixel right = way.first;
      right += way.rows.step.times(walk.row() - way.rows.first);
      right += way.columns.step.times(column - 1 - way.side);
      OutlinePixel left = right;
      left += way.columns.step.times(-1);
      if (!is_free(left, walk.row()) && !is_free(right, walk.row())) continue;
      const std::uint32_t share = (walk.fraction() + 1024) >> 11;
      if (share != 0) pixels_.put(left, share);
      if (share != Pixels::kWhole) pixels_.put(right, Pixels::kWhole - share);
    }
  }

  /// True if the edge is certainly so far left or right of the rectangle that no ink reaches it.
  [[nodiscard]] static bool is_outside(const OutlineWay& way, const RasterPosition& a,
                                       const RasterPosition& b) {
    constexpr std::int32_t kReach = 2 * OutlineInk::kWidest;  // more than sqrt(2) kWidest + 1
    const std::int32_t left = (way.columns.first - kReach) * 16;
    const std::int32_t right = (way.columns.end + kReach) * 16;
    return (a.x < left && b.x < left) || (a.x > right && b.x > right);
  }

  static constexpr std::int32_t kHalfShare = 1024;  ///< of a pixel, which has 16 fraction bits

  Pixels& pixels_;
  const std::int32_t width_;
  const OutlineWay* way_ = nullptr;  ///< of the edge that is walked
  OutlineDepth depth_;
  const OutlineRect rect_;
};

/// True if the next edge of a list is the same crease, seen from its other side.
[[nodiscard]] constexpr bool is_crease(std::span<const OutlineEdge> edges, std::size_t i) {
  return i + 1 < edges.size() && edges[i].from == edges[i + 1].to && edges[i].to == edges[i + 1].from;
}

}  // namespace detail

/// Draws the outlines of a picture, or of a band or rectangle of one, as lines of ink with soft edges:
/// outside of each surface, and in the middle of creases. Call it after all opaque objects are drawn with
/// `depth`, and before smooth_outlines(), which then smooths the side of the ink where the surface is. Pixels
/// change in the common bounds of the viewport and the sink, where nothing nearer than the outline is drawn.
///
/// All arguments, the status and the pixels in bands are as those of smooth_outlines(), with these
/// differences:
///
/// - `sink` may have fewer than 4 bits per pixel. Ink then covers pixels from one half on.
/// - `memory`: for each pixel that ink covers in part, about as many as outlines have pixels, or twice
///   as many with creases. It may be the memory of smooth_outlines(). Formats with fewer than 4 bits need
///   none.
/// - A band needs one row more above and below for creases, and one for smoothing: up to two.
/// - kUnsupported says only that the sink cannot be read; kInvalidArgument that the width is out of range.
template <PixelSink Sink>
[[nodiscard]] ARCSPAN_OUTLINE Status ink_outlines(const OutlineList& outlines, const OutlineInk& ink,
                                                  Sink& sink, const DepthBuffer& depth,
                                                  std::span<OutlineGap<typename Sink::Format>> memory) {
  if constexpr (!SinkInMemory<Sink>) {
    return Status::kUnsupported;
  } else {
    if (ink.width < 1 || ink.width > OutlineInk::kWidest) return Status::kInvalidArgument;
    const std::span<const OutlineEdge> edges = outlines.edges();
    if (edges.empty()) return Status::kOk;
    const detail::Scissor scissor(outlines.viewport(), sink.bounds());
    const Status status = detail::check_target(scissor, sink, depth);
    if (!ok(status)) return status;
    if (scissor.rect().empty()) return Status::kOk;
    if (detail::kCanBlend<typename Sink::Format> && memory.empty()) return Status::kBufferTooSmall;
    detail::InkPixels<Sink> pixels(sink, depth, ink.colour, memory);
    detail::OutlineInker inker(scissor, depth, ink.width, pixels);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!detail::is_crease(edges, i)) {
        inker.ink_outline(edges[i]);
      } else {
        if (ink.creases) inker.ink_crease(edges[i]);
        ++i;
      }
    }
    pixels.apply();
    return pixels.status();
  }
}

}  // namespace arcspan
