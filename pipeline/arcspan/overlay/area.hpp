// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// Text and simple shapes over a picture: free functions that write into any PixelSink what lies within its
/// bounds(). A program calls them for each band after it has drawn the scene and before it sends the band.
/// Coordinates are pixels of the picture and may have any value, so that the same calls with the same
/// arguments draw a picture as a whole, band by band or rectangle by rectangle.
namespace arcspan::overlay {

/// A pixel of the picture, which need not lie within it: column x, row y, y down.
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

namespace detail {

/// a + b, saturated. No rectangle holds a pixel in column or row INT32_MAX.
[[nodiscard]] constexpr std::int32_t saturated_add(std::int32_t a, std::int32_t b) {
  const std::int32_t sum = wrap_add(a, b);
  if (((a ^ sum) & (b ^ sum)) < 0) [[unlikely]]
    return a < 0 ? INT32_MIN : INT32_MAX;
  return sum;
}

/// a - b, saturated.
[[nodiscard]] constexpr std::int32_t saturated_sub(std::int32_t a, std::int32_t b) {
  const std::int32_t difference = wrap_sub(a, b);
  if (((a ^ b) & (a ^ difference)) < 0) [[unlikely]]
    return a < 0 ? INT32_MIN : INT32_MAX;
  return difference;
}

/// The rectangle of `width` by `height` pixels whose upper left pixel is `at`.
[[nodiscard]] constexpr Rect rect_at(Point at, std::int32_t width, std::int32_t height) {
  return {at.x, at.y, saturated_add(at.x, width), saturated_add(at.y, height)};
}

/// The pixels that two rectangles share; empty() if there are none.
[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  return {a.left > b.left ? a.left : b.left, a.top > b.top ? a.top : b.top,
          a.right < b.right ? a.right : b.right, a.bottom < b.bottom ? a.bottom : b.bottom};
}

/// What a sink says about itself before anything is drawn.
template <class Sink>
[[nodiscard]] constexpr Status status_of(const Sink& sink) {
  if constexpr (ChecksItself<Sink>) return sink.status();
  return Status::kOk;
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
