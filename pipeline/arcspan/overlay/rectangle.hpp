// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/mixed_pixels.hpp>
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

/// Mixes `opacity` 32nds of a colour, at most 32, into the pixels of a rectangle: for panes behind text, and
/// fades. With few levels it changes in steps; Mono flips at about half. Returns as without `opacity`.
template <PixelSink Sink>
constexpr Status fill_rectangle(Sink& sink, const Rect& rect, Rgb8 colour, std::uint32_t opacity) {
  using Format = typename Sink::Format;
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  const Rect part = detail::intersection(rect, sink.bounds());
  if (part.empty()) return Status::kOk;
  const typename Format::Encoded encoded = Format::encode(colour);
  const std::uint32_t share = opacity < 32 ? opacity : 32;
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    const Span run{y, part.left, part.right - part.left};
    typename Format::Cursor cursor = sink.open(run);
    for (std::int32_t left = run.count; left > 0; --left, cursor.next())
      cursor.write(arcspan::detail::mixed_pixels<Format>(cursor.read(), encoded, share));
    if (const Status status = sink.close(run); !ok(status)) return status;
  }
  return Status::kOk;
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
