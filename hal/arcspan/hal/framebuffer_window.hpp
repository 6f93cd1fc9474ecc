// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/fill.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::hal {

/// How the rows of a window lie in memory, in Words of the format.
struct RowLayout {
  std::int32_t stride = 0;  ///< from one row to the next, 0...INT32_MAX
  std::int32_t offset = 0;  ///< from the start of the memory to the window's first pixel, 0...INT32_MAX
};

/// A Framebuffer whose rows are not next to each other in memory: a window in a larger picture, or rows that
/// are padded to an alignment. Words between its rows are neither read nor written. The bits that a last Word
/// has beyond the window's width keep their value.
///
/// The window of a picture with `stride` Words per row whose upper left pixel is (x, y) has the offset
/// y * stride + words_per_row(x), where x must be a multiple of the pixels per Word.
template <PixelFormat F>
class FramebufferWindow : public Framebuffer<F> {
 public:
  using typename Framebuffer<F>::Word;
  using RowsInMemory = FramebufferWindow;
  using FromFirstColumn = FramebufferWindow;

  /// status() is kInvalidArgument unless `width`, `rows` and `first_row` are as for Framebuffer, the offset
  /// is not negative, the stride at least words_per_row(width) and the last row's end at most INT32_MAX;
  /// kBufferTooSmall if it lies behind `memory`.
  constexpr FramebufferWindow(std::span<Word> memory, std::int32_t width, std::int32_t rows,
                              const RowLayout& layout, std::int32_t first_row = 0)
      : Framebuffer<F>(check(memory.size(), width, rows, layout), memory.data() + start(memory, layout),
                       layout.stride, width, rows, first_row) {}

  /// Sets every pixel of the window to `colour`.
  constexpr void clear(Rgb8 colour) {
    const typename F::Encoded encoded = F::encode(colour);
    const Rect bounds = this->bounds();
    for (std::int32_t y = bounds.top; y < bounds.bottom; ++y) {
      if constexpr (requires(typename F::Cursor cursor) { cursor.pixels(); }) {
        fill(this->row(y), static_cast<std::size_t>(bounds.right), encoded);
      } else {
        typename F::Cursor cursor(this->row(y), 0);
        for (std::int32_t left = bounds.right; left > 0; --left, cursor.next()) cursor.write(encoded);
      }
    }
  }

 private:
  [[nodiscard]] static constexpr Status check(std::size_t words, std::int32_t width, std::int32_t rows,
                                              const RowLayout& layout) {
    const Status status = arcspan::detail::check_band_size(width, rows, F::words_per_row, SIZE_MAX);
    if (!ok(status)) return status;
    const std::size_t row = F::words_per_row(width);
    if (layout.offset < 0 || layout.stride < 0 || static_cast<std::size_t>(layout.stride) < row)
      return Status::kInvalidArgument;
    if (rows == 0) return Status::kOk;
    const std::uint64_t end =
        static_cast<std::uint64_t>(layout.offset) +
        static_cast<std::uint64_t>(layout.stride) * static_cast<std::uint32_t>(rows - 1) + row;
    if (end > INT32_MAX) return Status::kInvalidArgument;  // rows are addressed by 32-bit products
    return end <= words ? Status::kOk : Status::kBufferTooSmall;
  }
  /// The offset, or 0 if it lies behind the memory.
  [[nodiscard]] static constexpr std::size_t start(std::span<Word> memory, const RowLayout& layout) {
    const auto offset = static_cast<std::size_t>(layout.offset < 0 ? 0 : layout.offset);
    return offset <= memory.size() ? offset : 0;
  }
};

static_assert(SinkInMemory<FramebufferWindow<Rgb565>> && SinkInMemory<FramebufferWindow<Mono>>);

}  // namespace arcspan::hal
