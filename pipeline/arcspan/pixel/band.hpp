// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>

#include <cstddef>
#include <cstdint>

/// Checks of framebuffers and depth buffers. Both hold a band: some rows of a picture, in memory of the
/// caller, which move_to() turns into other rows.
namespace arcspan::detail {

/// The largest width and the largest number of rows of a band. The words of such a band fit 31 bits.
inline constexpr std::int32_t kMostBandSide = 32767;

/// Returns kInvalidArgument if a side is outside 0...kMostBandSide, kBufferTooSmall if `words` words of
/// memory do not hold the band, else kOk. `words_per_row` is a function of the width and at most four times
/// that, so that the product fits 32 bits; std::size_t may have 16.
template <class WordsPerRow>
[[nodiscard]] constexpr Status check_band_size(std::int32_t width, std::int32_t rows,
                                               const WordsPerRow& words_per_row, std::size_t words) {
  if (width < 0 || rows < 0 || width > kMostBandSide || rows > kMostBandSide) return Status::kInvalidArgument;
  const std::uint32_t needed =
      static_cast<std::uint32_t>(words_per_row(width)) * static_cast<std::uint32_t>(rows);
  return words < needed ? Status::kBufferTooSmall : Status::kOk;
}

/// Moves the rows of `bounds` to `first_row` and returns kOk. If `first_row` is negative or the rows would
/// end beyond INT32_MAX, returns kInvalidArgument and makes `bounds` empty by moving its left side to its
/// right one; the next valid row undoes that.
[[nodiscard]] constexpr Status move_band(Rect& bounds, std::int32_t first_row) {
  const std::int32_t rows = bounds.height();
  const bool valid = first_row >= 0 && first_row <= INT32_MAX - rows;
  bounds.left = valid ? 0 : bounds.right;
  if (!valid) return Status::kInvalidArgument;
  bounds.top = first_row;
  bounds.bottom = first_row + rows;
  return Status::kOk;
}

/// True if `run` has pixels, and all of them lie within `bounds`.
[[nodiscard]] constexpr bool is_within(const Span& run, const Rect& bounds) {
  return run.count > 0 && run.y >= bounds.top && run.y < bounds.bottom && run.x >= bounds.left &&
         run.x <= bounds.right - run.count;
}

}  // namespace arcspan::detail
