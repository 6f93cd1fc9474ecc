// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::overlay {

namespace detail {

/// Fills a rectangle that lies within the sink's bounds() or is empty().
template <PixelSink Sink>
[[nodiscard]] constexpr Status fill_within(Sink& sink, const Rect& rect,
                                           typename Sink::Format::Encoded encoded) {
  return rect.empty() ? Status::kOk : arcspan::detail::fill_rows(sink, rect, encoded);
}

}  // namespace detail

/// Fills a rectangle; one that is empty() has no pixels. Returns the first status of the sink that is not
/// kOk, else kOk.
template <PixelSink Sink>
constexpr Status fill_rectangle(Sink& sink, const Rect& rect, Rgb8 colour) {
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  return detail::fill_within(sink, detail::intersection(rect, sink.bounds()), Sink::Format::encode(colour));
}

/// Draws the border of a rectangle, `thickness` pixels wide and within it; no pixel is drawn twice. With a
/// thickness of half a side or more the rectangle is filled, with 0 or less nothing is drawn. Returns as
/// fill_rectangle() does.
template <PixelSink Sink>
constexpr Status draw_frame(Sink& sink, const Rect& rect, Rgb8 colour, std::int32_t thickness = 1) {
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  if (rect.empty() || thickness <= 0) return Status::kOk;
  const auto twice = 2 * static_cast<std::uint32_t>(thickness);
  if (twice >= detail::extent(rect.left, rect.right) || twice >= detail::extent(rect.top, rect.bottom))
    return fill_rectangle(sink, rect, colour);
  const Rect inner{rect.left + thickness, rect.top + thickness, rect.right - thickness,
                   rect.bottom - thickness};
  const Rect sides[] = {{rect.left, rect.top, rect.right, inner.top},
                        {rect.left, inner.top, inner.left, inner.bottom},
                        {inner.right, inner.top, rect.right, inner.bottom},
                        {rect.left, inner.bottom, rect.right, rect.bottom}};
  for (const Rect& side : sides) {
    const Status status = fill_rectangle(sink, side, colour);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace arcspan::overlay
