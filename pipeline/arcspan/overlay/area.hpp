// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

/// Text and simple shapes over a picture: free functions that write into any PixelSink what lies within its
/// bounds(). A program calls them for each band after it has drawn the scene and before it sends the band.
/// Coordinates are pixels of the picture and need not lie within it, so that the same calls with the same
/// arguments draw a picture as a whole, band by band or rectangle by rectangle. Those beyond +-2^30 are
/// taken modulo 2^32: what begins there is not seen in a picture whose sides are less than 2^30.
namespace arcspan::overlay {

/// A pixel of the picture, which need not lie within it: column x, row y, y down.
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

namespace detail {

using arcspan::detail::intersection;
using arcspan::detail::status_of;

/// The rectangle of `width` by `height` pixels whose upper left pixel is `at`.
[[nodiscard]] constexpr Rect rect_at(Point at, std::int32_t width, std::int32_t height) {
  return {at.x, at.y, wrap_add(at.x, width), wrap_add(at.y, height)};
}

/// The distance of the sides of a rectangle, 0 if they are not in order.
[[nodiscard]] constexpr std::uint32_t extent(std::int32_t first, std::int32_t end) {
  return first < end ? static_cast<std::uint32_t>(end) - static_cast<std::uint32_t>(first) : 0;
}

/// Writes `encoded` into each pixel of a run, which lies within the sink's bounds().
template <PixelSink Sink>
[[nodiscard]] constexpr Status fill_run(Sink& sink, const Span& run, typename Sink::Format::Encoded encoded) {
  typename Sink::Format::Cursor cursor = sink.open(run);
  for (std::int32_t left = run.count; left > 0; --left, cursor.next()) cursor.write(encoded);
  return sink.close(run);
}

}  // namespace detail

}  // namespace arcspan::overlay
