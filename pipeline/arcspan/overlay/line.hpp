// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/overlay/area.hpp>
#include <arcspan/pixel/colour.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstdint>

namespace arcspan::overlay {

namespace detail {

/// One coordinate of a line as the other one, the longer, advances: start +- minor * i / major at step i,
/// rounded to the nearest. A half is a step further if `half_steps`.
class LineStep {
 public:
  /// Begins at step `i`; minor <= major and i <= major.
  constexpr LineStep(std::int32_t start, std::uint32_t minor, std::uint32_t major, std::uint32_t i,
                     bool backwards, bool half_steps)
      : minor_(minor), major_(major), step_(backwards ? -1 : 1) {
    std::uint32_t steps = 0;
    // minor * i by doubling: a product of 64 bits would have to be divided.
    for (std::uint32_t bit = std::uint32_t{1} << 31; i != 0 && bit != 0; bit >>= 1) {
      steps = 2 * steps + add(rest_);
      if ((i & bit) != 0) steps += add(minor);
    }
    if (major != 0) steps += add((half_steps ? major : major - 1) / 2);
    at_ = wrap_add(start, wrap_mul(static_cast<std::int32_t>(steps), step_));
  }

  [[nodiscard]] constexpr std::int32_t at() const { return at_; }
  constexpr void advance() {
    if (add(minor_) != 0) at_ = wrap_add(at_, step_);
  }

 private:
  /// Adds `part` / major_, at most 1, and returns the whole steps. The sum of rest_ and `part` may have 33
  /// bits.
  constexpr std::uint32_t add(std::uint32_t part) {
    const std::uint32_t room = major_ - part;
    if (rest_ >= room) {
      rest_ -= room;
      return 1;
    }
    rest_ += part;
    return 0;
  }

  std::int32_t at_ = 0;
  std::uint32_t rest_ = 0;  ///< of the division by major_
  std::uint32_t minor_;
  std::uint32_t major_;
  std::int32_t step_;
};

/// The distance of two coordinates.
[[nodiscard]] constexpr std::uint32_t distance(std::int32_t a, std::int32_t b) {
  return a < b ? static_cast<std::uint32_t>(b) - static_cast<std::uint32_t>(a)
               : static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b);
}

/// Draws a line that is at least as wide as high, from its left end to its right one: a run per row.
template <PixelSink Sink>
[[nodiscard]] constexpr Status draw_wide_line(Sink& sink, Point from, Point to, const Rect& clip,
                                              typename Sink::Format::Encoded colour) {
  const std::int32_t first = from.x < clip.left ? clip.left : from.x;
  const std::int32_t last = to.x < clip.right ? to.x : clip.right - 1;
  LineStep step(from.y, distance(from.y, to.y), distance(from.x, to.x),
                first <= to.x ? distance(from.x, first) : 0, to.y < from.y, true);
  for (std::int32_t x = first; x <= last;) {
    const std::int32_t y = step.at();
    std::int32_t end = x;
    do {
      ++end;
      step.advance();
    } while (end <= last && step.at() == y);
    if (y >= clip.top && y < clip.bottom) {
      const Status status = fill_run(sink, {y, x, end - x}, colour);
      if (!ok(status)) return status;
    }
    x = end;
  }
  return Status::kOk;
}

/// Draws a line that is higher than wide, from its upper end to its lower one: a pixel per row.
template <PixelSink Sink>
[[nodiscard]] constexpr Status draw_high_line(Sink& sink, Point from, Point to, const Rect& clip,
                                              typename Sink::Format::Encoded colour) {
  const std::int32_t first = from.y < clip.top ? clip.top : from.y;
  const std::int32_t last = to.y < clip.bottom ? to.y : clip.bottom - 1;
  LineStep step(from.x, distance(from.x, to.x), distance(from.y, to.y),
                first <= to.y ? distance(from.y, first) : 0, to.x < from.x, to.x < from.x);
  for (std::int32_t y = first; y <= last; ++y, step.advance()) {
    const std::int32_t x = step.at();
    if (x < clip.left || x >= clip.right) continue;
    const Status status = fill_run(sink, {y, x, 1}, colour);
    if (!ok(status)) return status;
  }
  return Status::kOk;
}

}  // namespace detail

/// Draws a line one pixel wide from the middle of pixel `a` to that of pixel `b`, both included. It has one
/// pixel in each column if it is at least as wide as high, else one in each row: the one that contains the
/// line at the centre of that column or row. Where that is the border of two pixels, the line counts as a
/// little further left, as in draw_lines(). The line from b to a has the same pixels. Returns the first
/// status of the sink that is not kOk, else kOk.
template <PixelSink Sink>
constexpr Status draw_line(Sink& sink, Point a, Point b, Rgb8 colour) {
  if (const Status status = detail::status_of(sink); !ok(status)) return status;
  const Rect clip = sink.bounds();
  const std::int32_t top = a.y < b.y ? a.y : b.y;
  const std::int32_t bottom = a.y < b.y ? b.y : a.y;
  if (clip.empty() || bottom < clip.top || top >= clip.bottom) return Status::kOk;
  const auto encoded = Sink::Format::encode(colour);
  if (detail::distance(a.x, b.x) >= detail::distance(a.y, b.y)) {
    const bool in_order = a.x <= b.x;
    return detail::draw_wide_line(sink, in_order ? a : b, in_order ? b : a, clip, encoded);
  }
  const bool in_order = a.y <= b.y;
  return detail::draw_high_line(sink, in_order ? a : b, in_order ? b : a, clip, encoded);
}

}  // namespace arcspan::overlay
