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

/// The smallest rectangle that contains both; an empty one has no place.
[[nodiscard]] constexpr Rect bounding_rect(const Rect& a, const Rect& b) {
  if (a.empty()) return b.empty() ? Rect{} : b;
  if (b.empty()) return a;
  return {a.left < b.left ? a.left : b.left, a.top < b.top ? a.top : b.top,
          a.right > b.right ? a.right : b.right, a.bottom > b.bottom ? a.bottom : b.bottom};
}

namespace detail {

/// The pixels that two rectangles share; empty() if there are none.
[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  return {a.left > b.left ? a.left : b.left, a.top > b.top ? a.top : b.top,
          a.right < b.right ? a.right : b.right, a.bottom < b.bottom ? a.bottom : b.bottom};
}
/// True if all sides of `inner` lie within `outer`.
[[nodiscard]] constexpr bool contains(const Rect& outer, const Rect& inner) {
  return outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right &&
         outer.bottom >= inner.bottom;
}

}  // namespace detail

/// The receiver of drawn pixels: a framebuffer, a band of one, a line buffer. The smallest complete sink:
///
///     struct GreyPicture {
///       using Format = Gray8;
///       static constexpr std::int32_t kWidth = 64;
///       static constexpr std::int32_t kHeight = 48;
///
///       [[nodiscard]] Rect bounds() const { return {0, 0, kWidth, kHeight}; }
///       [[nodiscard]] Format::Cursor open(const Span& run) { return {pixels[run.y], run.x}; }
///       [[nodiscard]] Status close(const Span&) { return Status::kOk; }
///
///       std::uint8_t pixels[kHeight][kWidth] = {};
///     };
///
/// bounds() is the part of the picture that the sink takes, and does not change during a draw call. The
/// pipeline clips to it, so a sink need not check coordinates.
///
/// The pipeline draws one run after another: it calls open(run), writes pixels through the cursor from left
/// to right, and calls close(run) with the same run. A run lies within bounds() and has at least one pixel.
/// Runs come triangle by triangle and row by row downwards, and may cover pixels of earlier runs. Pixels that
/// fail the depth test are stepped over, and cursors of formats below 8 bits read the word that they change:
/// the memory that open() returns must hold the present pixels of the run. A sink that streams returns a line
/// buffer and sends it in close().
///
/// close() returns the status of the run. On any other status than kOk the draw call ends at once, without
/// another call of the sink, and returns that status.
///
/// A sink may have `Status status() const`: if it is not kOk, a draw call returns it and draws nothing
/// (ChecksItself).
template <class S>
concept PixelSink = PixelFormat<typename S::Format> && requires(S& sink, const Span& run) {
  { sink.bounds() } -> std::same_as<Rect>;
  { sink.open(run) } -> std::same_as<typename S::Format::Cursor>;
  { sink.close(run) } -> std::same_as<Status>;
};

/// Optional part of a sink: a status() that says whether it can take pixels.
template <class S>
concept ChecksItself = requires(const S& sink) {
  { sink.status() } -> std::same_as<Status>;
};

namespace detail {

/// The status of a sink that has one, else kOk.
template <class Sink>
[[nodiscard]] constexpr Status status_of(const Sink& sink) {
  if constexpr (ChecksItself<Sink>) return sink.status();
  return Status::kOk;
}

}  // namespace detail

/// A sink whose bounds() begin at column 0, always. It declares that by `using FromFirstColumn =` its own
/// name, for less code: no row of a triangle begins left of it and in the picture. A class derived from it is
/// an ordinary sink, unless it declares itself as well.
template <class S>
concept SinkFromFirstColumn = PixelSink<S> && std::same_as<typename S::FromFirstColumn, S>;

/// A sink whose rows lie in memory, so that the span stage may step from row to row instead of calling
/// open(). close() is called for every run all the same.
///
/// row(y) is the Word of column 0 of row y of the picture, where that is or would be: bounds() may begin
/// right of it, and only Words of bounds() are read and written. row(y + 1) is stride_bytes() bytes behind
/// it, a multiple of the size of a Word that is an integer. A sink declares itself by `using RowsInMemory =`
/// its own name. A class derived from it is an ordinary sink, unless it declares itself as well, so that its
/// own open() is called.
template <class S>
concept SinkInMemory = PixelSink<S> && std::same_as<typename S::RowsInMemory, S> &&
    requires(const S& sink, std::int32_t y) {
  { sink.row(y) } -> std::same_as<typename S::Format::Word*>;
  { sink.stride_bytes() } -> std::same_as<std::int32_t>;
};

}  // namespace arcspan
