// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/checked.hpp>
#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/mono.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/pixel/rgb565.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace arcspan::hal {

/// A pixel sink over caller memory that holds a picture or a horizontal band of one. The memory must outlive
/// it.
///
/// A band covers rows first_row ... first_row + rows - 1 of the picture. It accepts the same drawing calls as
/// a whole picture and keeps only its own rows: draw, send, `move_to` the next band, draw again.
template <PixelFormat F>
class Framebuffer {
 public:
  using Format = F;
  using Word = typename F::Word;
  using RowsInMemory = Framebuffer;
  using FromFirstColumn = Framebuffer;

  /// Number of Words that `rows` rows of `width` pixels need.
  [[nodiscard]] static constexpr std::size_t words(std::int32_t width, std::int32_t rows) {
    return F::words_per_row(width) * static_cast<std::size_t>(rows);
  }

  /// `memory` must hold at least words(width, rows), else status() is kBufferTooSmall. It is kInvalidArgument
  /// unless `width` and `rows` are in 0...32767 and `first_row` is as move_to() takes it. With any status but
  /// kOk bounds() is empty, and draw_mesh() returns the status.
  constexpr Framebuffer(std::span<Word> memory, std::int32_t width, std::int32_t rows,
                        std::int32_t first_row = 0)
      : status_(arcspan::detail::check_band_size(width, rows, F::words_per_row, memory.size())) {
    if (!ok(status_)) return;
    column_0_ = memory.data();
    stride_ = static_cast<std::int32_t>(F::words_per_row(width) * (sizeof(Word) / kUnit));
    bounds_ = {0, 0, width, rows};
    status_ = arcspan::detail::move_band(bounds_, first_row);
  }

  [[nodiscard]] constexpr Status status() const { return status_; }
  [[nodiscard]] constexpr Rect bounds() const { return bounds_; }

  /// The calls of PixelSink. `run` must lie inside bounds().
  [[nodiscard]] constexpr typename F::Cursor open(const Span& run) {
    ARCSPAN_CHECK(arcspan::detail::is_within(run, bounds_), "Framebuffer::open: the run leaves bounds()");
    return typename F::Cursor(row(run.y), run.x);
  }
  [[nodiscard]] constexpr Status close(const Span&) { return Status::kOk; }

  /// Makes this memory represent the band that starts at `first_row`. Its pixels are kept. `first_row` is
  /// 0...INT32_MAX - rows; otherwise status() is kInvalidArgument and bounds() empty until the next call.
  /// Without effect if the constructor was given too little memory or a wrong size.
  constexpr void move_to(std::int32_t first_row) {
    if (stride_ != kRefused) status_ = arcspan::detail::move_band(bounds_, first_row);
  }

  /// Sets every pixel to `colour`.
  constexpr void clear(Rgb8 colour) {
    const typename F::Encoded encoded = F::encode(colour);
    if constexpr (requires(typename F::Cursor cursor) { cursor.pixels(); }) {
      fill(column_0_, words(bounds_.right, arcspan::detail::band_rows(bounds_)), encoded);
    } else {
      clear_rows(encoded);
    }
  }

  /// Colour of pixel (x, y), which must lie inside bounds().
  [[nodiscard]] constexpr Rgb8 pixel(std::int32_t x, std::int32_t y) const {
    ARCSPAN_CHECK(arcspan::detail::is_within({y, x, 1}, bounds_), "Framebuffer::pixel: outside of bounds()");
    return F::decode(typename F::Cursor(row(y), x).read());
  }

  /// The Word of column 0 of row y of the picture, as SinkInMemory has it. The row must lie inside bounds().
  [[nodiscard]] constexpr Word* row(std::int32_t y) const { return row_at(y - bounds_.top); }
  /// Bytes from one row to the next.
  [[nodiscard]] constexpr std::int32_t stride_bytes() const { return stride_ * kUnit; }

 protected:
  /// The memory of the rectangle `held`. `column_0` is where column 0 of its first row is or would be;
  /// `status` is that of the arguments.
  constexpr Framebuffer(Status status, Word* column_0, std::int32_t stride_bytes, const Rect& held)
      : status_(status) {
    if (!ok(status_)) return;
    column_0_ = column_0;
    stride_ = stride_bytes / kUnit;
    bounds_ = held;
  }

  /// clear() for rows that are not next to each other, or for several pixels per Word.
  constexpr void clear_rows(typename F::Encoded encoded) {
    if (bounds_.width() == 0) return;
    for (std::int32_t i = 0; i < arcspan::detail::band_rows(bounds_); ++i) {
      fill_pixels(typename F::Cursor(row_at(i), bounds_.left), bounds_.width(), encoded);
    }
  }

 private:
  static constexpr std::int32_t kRefused = -1;
  static constexpr std::int32_t kUnit = arcspan::detail::kRowUnitBytes<Word>;

  /// The Word of column 0 of the i-th row. The product has 64 bits where memory can be as large.
  [[nodiscard]] constexpr Word* row_at(std::int32_t i) const {
    using Offset = std::common_type_t<std::ptrdiff_t, std::int32_t>;
    return arcspan::detail::moved_by_units(column_0_, static_cast<Offset>(i) * stride_);
  }

  Word* column_0_ = nullptr;        ///< of the first row
  std::int32_t stride_ = kRefused;  ///< in RowUnits; kRefused if the constructor's arguments were
  Rect bounds_{};
  Status status_;
};

static_assert(SinkInMemory<Framebuffer<Rgb565>> && SinkInMemory<Framebuffer<Mono>>);

}  // namespace arcspan::hal
