// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/status.hpp>

#include <concepts>
#include <cstdint>

namespace arcspan {

/// A run of pixels in one row: columns x ... x + count - 1 of row y, in pixels of the picture.
struct Span {
  std::int32_t y = 0;
  std::int32_t x = 0;
  std::int32_t count = 0;

  friend constexpr bool operator==(const Span&, const Span&) = default;
};

/// A half-open rectangle of pixels: columns left ... right - 1, rows top ... bottom - 1.
struct Rect {
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = 0;
  std::int32_t bottom = 0;

  [[nodiscard]] constexpr std::int32_t width() const { return right - left; }
  [[nodiscard]] constexpr std::int32_t height() const { return bottom - top; }
  [[nodiscard]] constexpr bool empty() const { return right <= left || bottom <= top; }
  friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

/// The seam between pipeline/ and whatever pixels flow into: a framebuffer, a band of one, a line buffer.
///
/// `bounds()` is the part of the picture that the sink takes; the pipeline clips to it, so a sink need not.
/// For every run the span stage calls `open`, writes each pixel that passes the depth test through the cursor
/// (from left to right, stepping over those that fail), and calls `close`. `open` gives memory that holds the
/// run's present pixels; a sink that streams may hand out a line buffer. `close` reports what became of the
/// run; anything but kOk stops the drawing and is returned by the draw call.
template <class S>
concept PixelSink = PixelFormat<typename S::Format> && requires(S& sink, const Span& run) {
  { sink.bounds() } -> std::same_as<Rect>;
  { sink.open(run) } -> std::same_as<typename S::Format::Cursor>;
  { sink.close(run) } -> std::same_as<Status>;
};

/// A sink whose rows lie in memory, each `stride()` Words behind the last, and that only needs to be told of
/// runs by close(): it says so by naming itself `RowsInMemory`. The span stage then steps from row to row in
/// place of calling `open`. (A class derived from such a sink is not one until it says so itself.)
template <class S>
concept SinkInMemory = PixelSink<S> && std::same_as<typename S::RowsInMemory, S> &&
    requires(const S& sink, std::int32_t y) {
  { sink.row(y) } -> std::same_as<typename S::Format::Word*>;
  { sink.stride() } -> std::same_as<std::int32_t>;
};

}  // namespace arcspan
