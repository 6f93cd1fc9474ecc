// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/status.hpp>
#include <arcspan/vertex/raster_vertex.hpp>
#include <arcspan/vertex/rotation.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::overlay {

/// The pointer of a gauge: it turns about the centre of pixel `pivot`, is `width` pixels wide at its tail and
/// narrows to one pixel at its tip.
struct Needle {
  static constexpr std::int32_t kMostLength = 900;
  static constexpr std::int32_t kMostWidth = 255;

  Point pivot{};
  Turn angle{};             ///< 0 points up, and the needle turns clockwise: 0x4000 points to the right
  std::int32_t length = 0;  ///< pixels from the pivot to the tip, 0...kMostLength
  std::int32_t width = 1;   ///< 1...kMostWidth
  std::int32_t tail = 0;    ///< pixels behind the pivot, 0...kMostLength

  [[nodiscard]] constexpr bool valid() const {
    return length >= 0 && length <= kMostLength && tail >= 0 && tail <= kMostLength && width >= 1 &&
           width <= kMostWidth;
  }
};

namespace detail {

/// The corners of a needle in 28.4 pixels from the upper left corner of its pivot: the two of its tail, then
/// those of its tip in the same direction.
[[nodiscard]] constexpr std::array<RasterPosition, 4> needle_corners(const Needle& needle) {
  const std::int64_t sin = sine(needle.angle).raw();
  const std::int64_t cos = sine(needle.angle + Turn{0x4000}).raw();
  // The corner `along` 16ths of a pixel towards the tip and `across` to the right of it.
  const auto corner = [=](std::int32_t along, std::int32_t across) {
    const auto rounded = [](std::int64_t product30) {
      return static_cast<std::int16_t>(((product30 + (std::int64_t{1} << 29)) >> 30) + 8);
    };
    return RasterPosition{rounded(along * sin + across * cos), rounded(across * sin - along * cos), 0};
  };
  const std::int32_t tail = -16 * needle.tail;
  const std::int32_t tip = 16 * needle.length;
  const std::int32_t half = 8 * needle.width;
  return {corner(tail, -half), corner(tail, half), corner(tip, 8), corner(tip, -8)};
}

/// An edge of a needle, stepped from row to row.
struct NeedleEdge {
  std::int32_t first_row;
  std::int32_t end_row;
  EdgeWalk walk;
};

/// The edge between two corners; its first row is `row` or a later one.
[[nodiscard]] constexpr NeedleEdge needle_edge(const RasterPosition& a, const RasterPosition& b,
                                               std::int32_t row) {
  const RasterPosition& top = a.y < b.y ? a : b;
  const RasterPosition& bottom = a.y < b.y ? b : a;
  NeedleEdge edge{first_row_at(top.y), first_row_at(bottom.y), {}};
  if (edge.first_row < row) edge.first_row = row;
  if (edge.first_row >= edge.end_row) return edge;
  EdgeSetup setup{};
  make_edge_setup(top, bottom, edge.first_row, setup);
  make_edge_walk(setup, top, bottom, edge.walk);
  return edge;
}

/// The rectangle of the pixels whose centres lie between the outermost corners, relative to the pivot.
[[nodiscard]] constexpr Rect corner_box(const std::array<RasterPosition, 4>& corners) {
  Rect box{INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
  for (const RasterPosition& corner : corners) {
    if (corner.x < box.left) box.left = corner.x;
    if (corner.x > box.right) box.right = corner.x;
    if (corner.y < box.top) box.top = corner.y;
    if (corner.y > box.bottom) box.bottom = corner.y;
  }
  return {first_row_at(box.left), first_row_at(box.top), first_row_at(box.right), first_row_at(box.bottom)};
}

}  // namespace detail

/// The rectangle that a needle covers: what to draw again when it moves, together with the rectangle before.
/// Empty if the needle is not valid().
[[nodiscard]] constexpr Rect needle_rect(const Needle& needle) {
  if (!needle.valid()) return {};
  const Rect box = detail::corner_box(detail::needle_corners(needle));
  const Point& pivot = needle.pivot;
  return {wrap_add(pivot.x, box.left), wrap_add(pivot.y, box.top), wrap_add(pivot.x, box.right),
          wrap_add(pivot.y, box.bottom)};
}

/// Draws a needle: the pixels whose centres lie within it, by the fill rule of triangles. Returns
/// kInvalidArgument if it is not valid(), else the first status of the sink that is not kOk, else kOk.
template <PixelSink Sink>
constexpr Status draw_needle(Sink& sink, const Needle& needle, Rgb8 colour) {
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  if (!needle.valid()) return Status::kInvalidArgument;
  const std::array<RasterPosition, 4> corners = detail::needle_corners(needle);
  const Rect bounds = sink.bounds();
  const Point& pivot = needle.pivot;
  const Rect around{wrap_sub(bounds.left, pivot.x), wrap_sub(bounds.top, pivot.y),
                    wrap_sub(bounds.right, pivot.x), wrap_sub(bounds.bottom, pivot.y)};
  const Rect visible = detail::intersection(detail::corner_box(corners), around);
  if (visible.empty()) return Status::kOk;
  std::array<detail::NeedleEdge, 4> edges{};
  for (std::size_t i = 0; i < 4; ++i)
    edges[i] = detail::needle_edge(corners[i], corners[(i + 1) & 3u], visible.top);
  const auto encoded = Sink::Format::encode(colour);
  for (std::int32_t y = visible.top; y < visible.bottom; ++y) {
    std::int32_t first = INT32_MAX;  // two edges cross a row, because the needle is convex
    std::int32_t end = INT32_MIN;
    for (detail::NeedleEdge& edge : edges) {
      if (y < edge.first_row || y >= edge.end_row) continue;
      const std::int32_t column = edge.walk.column();
      edge.walk.advance();
      if (column < first) first = column;
      if (column > end) end = column;
    }
    if (first < visible.left) first = visible.left;
    if (end > visible.right) end = visible.right;
    if (first >= end) continue;
    const Span run{wrap_add(pivot.y, y), wrap_add(pivot.x, first), end - first};
    if (const Status status = detail::fill_run(sink, run, encoded); !ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace arcspan::overlay
