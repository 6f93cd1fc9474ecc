// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/hal/framebuffer.hpp>
#include <arcspan/pixel/band.hpp>
#include <arcspan/pixel/pixel_format.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace arcspan::hal {

/// A rectangle of the picture in memory of somebody else, whose rows may be padded: a part of a larger
/// buffer, or the buffer that a user interface lends for drawing. Bytes between its rows are neither read nor
/// written, and bits of other columns keep their value.
///
/// The memory begins with the Word of the rectangle's upper left pixel. Where several pixels share a Word,
/// columns lie in it as in a row that begins with column 0.
template <PixelFormat F>
class FramebufferWindow : public Framebuffer<F> {
 public:
  using typename Framebuffer<F>::Word;
  using RowsInMemory = FramebufferWindow;

  /// bounds() is `held`, in pixels of the picture; `stride_bytes` bytes lie between the beginnings of two
  /// rows. status() is kInvalidArgument unless the sides of `held` are in 0...32767 and in order, the stride
  /// holds a row and, if a Word is an integer, is a multiple of its size, the memory is aligned for a Word,
  /// and the last row ends at most INT32_MAX bytes behind the first Word; kBufferTooSmall if it ends behind
  /// `memory`.
  FramebufferWindow(std::span<std::byte> memory, const Rect& held, std::int32_t stride_bytes)
      : Framebuffer<F>(check(memory, held, stride_bytes), column_0(memory, held), stride_bytes, held) {}

  /// The least `stride_bytes` of a rectangle: that of rows without padding. The sides of `held` are in
  /// 0...32767 and in order.
  [[nodiscard]] static constexpr std::int32_t least_stride(const Rect& held) {
    // At most 32767 words; their bytes do not fit a size_t of 16 bits.
    return static_cast<std::int32_t>(F::words_per_row(held.right - first_of_word(held.left))) *
           std::int32_t{sizeof(Word)};
  }

  /// Sets every pixel of the window to `colour`.
  void clear(Rgb8 colour) { this->clear_rows(F::encode(colour)); }

 private:
  /// The distance of columns that begin a Word.
  static constexpr std::int32_t kColumnStep = [] {
    std::int32_t step = 1;
    while (static_cast<std::size_t>(step) * F::kBitsPerPixel % (8 * sizeof(Word)) != 0) ++step;
    return step;
  }();
  static_assert(F::words_per_row(kColumnStep) * sizeof(Word) * 8 ==
                    static_cast<std::size_t>(kColumnStep) * F::kBitsPerPixel,
                "kBitsPerPixel counts all bits that a pixel takes in memory, also unused ones");

  /// The column that begins the Word of column x.
  [[nodiscard]] static constexpr std::int32_t first_of_word(std::int32_t x) { return x - x % kColumnStep; }
  [[nodiscard]] static Word* column_0(std::span<std::byte> memory, const Rect& held) {
    return arcspan::detail::column_0_of(static_cast<Word*>(static_cast<void*>(memory.data())),
                                        F::words_per_row(first_of_word(held.left)));
  }
  [[nodiscard]] static Status check(std::span<std::byte> memory, const Rect& held,
                                    std::int32_t stride_bytes) {
    const Status status = arcspan::detail::check_band_rect(held, F::words_per_row, SIZE_MAX);
    if (!ok(status)) return status;
    const auto row = static_cast<std::uint32_t>(least_stride(held));
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(memory.data());
    if (stride_bytes < 0 || static_cast<std::uint32_t>(stride_bytes) < row ||
        stride_bytes % arcspan::detail::kRowUnitBytes<Word> != 0 || address % alignof(Word) != 0)
      return Status::kInvalidArgument;
    if (held.empty()) return Status::kOk;
    const std::uint64_t end =
        static_cast<std::uint64_t>(stride_bytes) * static_cast<std::uint32_t>(held.height() - 1) + row;
    if (end > INT32_MAX) return Status::kInvalidArgument;  // rows are addressed by 32-bit products
    return end <= memory.size() ? Status::kOk : Status::kBufferTooSmall;
  }
};

static_assert(SinkInMemory<FramebufferWindow<Rgb565>> && SinkInMemory<FramebufferWindow<Mono>>);
static_assert(!SinkFromFirstColumn<FramebufferWindow<Rgb565>>);

}  // namespace arcspan::hal
