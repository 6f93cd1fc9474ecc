// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/shading/method.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/span/linear_walk.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

/// The span stage: per row and per pixel only multiply, shift, add, compare and look up.
namespace arcspan {

/// Where the middle pixel of the viewport lies in the picture: commands are relative to it.
struct RasterOrigin {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

namespace detail {

/// Draws one run of pixels: the colours of `run` through `cursor`, with the depth test of `Depth`.
template <class Format, ShadingMethod Method, DepthTarget Depth>
[[gnu::always_inline]] constexpr void draw_run(typename Format::Cursor cursor, const Span& span,
                                               typename Method::Run& run,
                                               const typename Method::Object& object, const Depth& depth,
                                               Linear z, Linear dz) {
  [[maybe_unused]] std::uint16_t* at = nullptr;
  if constexpr (Depth::kTests) at = depth.row(span.y) + span.x;
  for (std::int32_t i = 0; i < span.count; ++i) {
    if constexpr (Depth::kTests) {
      const auto nearness = static_cast<std::uint16_t>(z.raw() >> Linear::kFraction);
      if (nearness < *at) {
        *at = nearness;
        cursor.write(encode_at<Format>(run.colour(object), span.x + i, span.y));
      }
      ++at;
      z += dz;
    } else {
      cursor.write(encode_at<Format>(run.colour(object), span.x + i, span.y));
    }
    cursor.next();
    run.next();
  }
}

/// Everything that goes down the rows of one command, in place.
template <ShadingMethod Method>
struct CommandWalk {
  EdgeWalk* long_edge;
  EdgeWalk* short_edge;
  LinearWalk depth;
  typename Method::Walker shade;
  bool middle_left;

  constexpr explicit CommandWalk(TriangleCommand<Method>& command)
      : long_edge(&command.long_edge),
        short_edge(&command.upper_edge),
        depth(command.depth, command.middle_left),
        shade(command.shade),
        middle_left(command.middle_left) {}

  [[nodiscard]] constexpr const EdgeWalk& left() const { return middle_left ? *short_edge : *long_edge; }
  [[nodiscard]] constexpr const EdgeWalk& right() const { return middle_left ? *long_edge : *short_edge; }

  constexpr void next_row() {
    long_edge->advance();
    short_edge->advance();
    depth.next_row();
    shade.next_row();
  }
  constexpr void enter_lower(TriangleCommand<Method>& command) {
    short_edge = &command.lower_edge;
    depth.enter_lower();
    shade.enter_lower();
  }
};

[[nodiscard]] constexpr RowStart row_start(const EdgeWalk& left, const EdgeWalk& right,
                                           std::uint32_t fraction) {
  const std::int64_t width = right.x - left.x;
  if ((width >> 32) != 0) return {fraction, fraction, static_cast<std::uint32_t>(width >> 16), 16};
  const auto narrow = static_cast<std::uint32_t>(width);
  return {fraction, left.fine_fraction(), narrow | static_cast<std::uint32_t>(narrow == 0), 32};
}

/// Draws the row that `walk` stands on: picture row y, columns left ... right - 1 of the picture only.
template <ShadingMethod Method, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] constexpr Status draw_row(const CommandWalk<Method>& walk, std::int32_t y,
                                        std::int32_t origin_x, const Rect& clip,
                                        const typename Method::Object& object, Sink& sink,
                                        const Depth& depth) {
  const EdgeWalk& left = walk.left();
  const EdgeWalk& right = walk.right();
  const std::int32_t begin = left.column() + origin_x;
  const std::int32_t end = right.column() + origin_x;
  const std::int32_t first = begin < clip.left ? clip.left : begin;
  const std::int32_t last = end > clip.right ? clip.right : end;
  if (first >= last) return Status::kOk;
  for (std::int32_t x = first; x < last; x += Method::kLongestRun) {
    const Span span{y, x, last - x < Method::kLongestRun ? last - x : Method::kLongestRun};
    const std::uint32_t fraction = left.fraction() + (static_cast<std::uint32_t>(x - begin) << 16);
    typename Method::Run run = walk.shade.row(row_start(left, right, fraction));
    draw_run<typename Sink::Format, Method>(sink.open(span), span, run, object, depth,
                                            walk.depth.at(fraction), walk.depth.dx());
    const Status status = sink.close(span);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace detail

/// Draws a command into the sink's and the depth target's common bounds. Returns the sink's first status that
/// is not kOk, having stopped there. Rows above the bounds are walked, not skipped, so that a picture drawn
/// in bands is bit for bit the picture drawn at once.
template <ShadingMethod Method, PixelSink Sink, DepthTarget Depth>
[[nodiscard]] constexpr Status draw_command(TriangleCommand<Method>& command, const RasterOrigin& origin,
                                            const Rect& clip, const typename Method::Object& object,
                                            Sink& sink, const Depth& depth) {
  if (clip.empty() || command.end_row + origin.y <= clip.top || command.first_row + origin.y >= clip.bottom) {
    return Status::kOk;
  }
  detail::CommandWalk<Method> walk(command);
  const std::int32_t end =
      command.end_row + origin.y < clip.bottom ? command.end_row : clip.bottom - origin.y;
  for (std::int32_t row = command.first_row; row < end; ++row) {
    if (row == command.middle_row) walk.enter_lower(command);
    const std::int32_t y = row + origin.y;
    if (y >= clip.top) {
      const Status status = detail::draw_row(walk, y, origin.x, clip, object, sink, depth);
      if (!ok(status)) return status;
    }
    walk.next_row();
  }
  return Status::kOk;
}

}  // namespace arcspan
