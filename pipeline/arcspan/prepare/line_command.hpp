// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan {

/// The command that draws a line: preparation passes it to the span stage, as it passes a TriangleCommand.
/// All coordinates are pixels relative to the raster origin.
///
/// A line has one pixel in each column if it is at least as wide as high (`flat`), else one in each row. It
/// is the pixel that contains the line at the centre of that column or row. Before the first centre and
/// behind the last one it stays within the rectangle of the pixels that contain the ends. The depth is that
/// of the line at this centre; where it changes by more than 480 per pixel, it is spread evenly over the
/// pixels.
struct LineCommand {
  std::int16_t first_row;
  std::int16_t end_row;  ///< row after the last
  std::int16_t left;
  std::int16_t right;  ///< column after the last
  bool flat;
  bool leftwards;      ///< leads to the left on its way down
  std::uint16_t bias;  ///< how much nearer `depth` is than the line, whose fog is that of where it is
  /// If `flat`: the first column whose centre is not left of the line, at the lower border of the first row;
  /// unset if there is one row. Else: the column that contains the line at the centre of the first row.
  EdgeWalk edge;
  Linear depth;  ///< in column `left` if `flat`, else in the first row
  Linear step;   ///< of the depth per column or row
};

namespace detail {

/// Sets the depth along a line of `pixels` pixels and of `length` sixteenths of a pixel. `from` and `to` are
/// the depths of its ends; the centre of the first pixel is `inset` sixteenths behind the first end.
constexpr void place_line_depth(std::int32_t from, std::int32_t to, std::int32_t length, std::int32_t inset,
                                std::int32_t pixels, LineCommand& line) {
  // Up to this gradient, the depth at centres outside of the ends stays within kDepthMargin.
  constexpr std::int32_t kSteep = std::int32_t{480} << Linear::kFraction;
  line.step = Linear{};
  std::int32_t raw = wrap_shl(from < to ? from : to, Linear::kFraction);
  if (pixels > 1) {
    raw = wrap_shl(from, Linear::kFraction);
    line.step = gradient<Linear>(to - from, nonzero_reciprocal(static_cast<std::uint32_t>(length)),
                                 Subpixel::kFraction);
    if (line.step.raw() > kSteep || line.step.raw() < -kSteep) {
      line.step = gradient<Linear>(to - from, nonzero_reciprocal(static_cast<std::uint32_t>(pixels - 1)), 0);
    } else {
      raw += line.step.raw() * inset >> Subpixel::kFraction;
    }
  }
  line.depth = Linear::from_raw(raw);
}

/// The depth of an end of a line: nearer by `bias`, within the range of ClipTransform::depth().
[[nodiscard]] constexpr std::int32_t biased_depth(std::uint16_t z, std::uint16_t bias) {
  constexpr std::int32_t kNearest = ClipTransform::kDepthMargin;
  constexpr std::int32_t kFarthest = 65535 - ClipTransform::kDepthMargin;
  const std::int32_t nearer = std::int32_t{z} - bias;
  return nearer < kNearest ? kNearest : nearer > kFarthest ? kFarthest : nearer;
}

/// Sets the edge of a line whose upper end is `top`, at `offset` sixteenths of a row below it.
constexpr void place_line_edge(const RasterPosition& top, const RasterPosition& bottom, std::int32_t offset,
                               EdgeWalk& walk) {
  // An edge cannot begin above its top, so it begins a row further down.
  const bool above = offset < 0;
  const std::int32_t dy = bottom.y - top.y;
  const Reciprocal inverse = nonzero_reciprocal(static_cast<std::uint32_t>(dy));
  const EdgeSetup edge{dy, above ? offset + 16 : offset, inverse, {}};
  make_edge_walk(edge, top, bottom, walk);
  if (above) walk.x -= walk.step;
}

}  // namespace detail

/// Makes the command that draws the line from a to b, `bias` units of depth nearer than these. The line from
/// b to a has the same command. Both ends are within the guard band, as those from project() are.
constexpr void prepare_line(const RasterPosition& a, const RasterPosition& b, std::uint16_t bias,
                            LineCommand& line) {
  const bool in_order = a.y < b.y || (a.y == b.y && a.x <= b.x);
  const RasterPosition& top = in_order ? a : b;
  const RasterPosition& bottom = in_order ? b : a;
  const std::int32_t dx = bottom.x - top.x;
  const std::int32_t dy = bottom.y - top.y;
  line.leftwards = dx < 0;
  const std::int32_t width = dx < 0 ? -dx : dx;
  const std::int32_t left = dx < 0 ? bottom.x : top.x;
  line.first_row = static_cast<std::int16_t>(detail::pixel_of(top.y));
  line.end_row = static_cast<std::int16_t>(detail::pixel_of(bottom.y) + 1);
  line.left = static_cast<std::int16_t>(detail::pixel_of(left));
  line.right = static_cast<std::int16_t>(detail::pixel_of(left + width) + 1);
  line.flat = width >= dy;
  line.edge = {};
  const std::int32_t above = detail::biased_depth(top.z, bias);
  const std::int32_t below = detail::biased_depth(bottom.z, bias);
  // Less than the bias where that ends at the near plane, the mean of both ends.
  line.bias =
      static_cast<std::uint16_t>((std::int32_t{top.z} - above + (std::int32_t{bottom.z} - below)) >> 1);
  if (line.flat) {
    const std::int32_t inset = line.left * 16 + 8 - left;
    detail::place_line_depth(line.leftwards ? below : above, line.leftwards ? above : below, width, inset,
                             line.right - line.left, line);
    if (line.end_row - line.first_row > 1) {
      detail::place_line_edge(top, bottom, line.first_row * 16 + 16 - top.y, line.edge);
    }
  } else {
    const std::int32_t inset = line.first_row * 16 + 8 - top.y;
    detail::place_line_depth(above, below, dy, inset, line.end_row - line.first_row, line);
    detail::place_line_edge(top, bottom, inset, line.edge);
    line.edge.x -= std::int64_t{1} << 31;  // from the first centre to the right to the pixel that contains it
  }
}

}  // namespace arcspan
