// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/sink.hpp>
#include <arcspan/status.hpp>
#include <arcspan/target.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Checks and addresses of framebuffers and depth buffers. Both hold a band: a rectangle of a picture, in
/// memory of the caller, which move_to() turns into other rows.
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

/// check_band_size() of a rectangle of the picture, with kInvalidArgument also if one of its sides is outside
/// 0...kMostBandSide.
template <class WordsPerRow>
[[nodiscard]] constexpr Status check_band_rect(const Rect& held, const WordsPerRow& words_per_row,
                                               std::size_t words) {
  for (const std::int32_t side : {held.left, held.top, held.right, held.bottom})
    if (side < 0 || side > kMostBandSide) return Status::kInvalidArgument;
  return check_band_size(held.width(), held.height(), words_per_row, words);
}

/// The rows of the memory behind `bounds`, which are also known while move_band() has made it empty.
[[nodiscard]] constexpr std::int32_t band_rows(const Rect& bounds) {
  return bounds.bottom < bounds.top ? bounds.top - bounds.bottom : bounds.height();
}

/// Moves the rows of `bounds` to `first_row` and returns kOk. If `first_row` is negative or the rows would
/// end beyond INT32_MAX, returns kInvalidArgument and makes `bounds` empty by exchanging its top and its
/// bottom; the next valid row undoes that.
[[nodiscard]] constexpr Status move_band(Rect& bounds, std::int32_t first_row) {
  const std::int32_t rows = band_rows(bounds);
  const bool valid = first_row >= 0 && first_row <= INT32_MAX - rows;
  bounds.top = valid ? first_row : rows;
  bounds.bottom = valid ? first_row + rows : 0;
  return valid ? Status::kOk : Status::kInvalidArgument;
}

/// The unit of distances between rows: a Word if it is an integer, else a byte (Rgb888).
template <class Word>
using RowUnit = std::conditional_t<std::is_integral_v<Word>, Word, std::byte>;
template <class Word>
inline constexpr std::int32_t kRowUnitBytes = std::is_integral_v<Word> ? std::int32_t{sizeof(Word)} : 1;

/// The Word `units` RowUnits behind `at` in its memory.
template <class Word, class Units>
[[nodiscard]] ARCSPAN_INLINE constexpr Word* moved_by_units(Word* at, Units units) {
  if constexpr (std::is_same_v<RowUnit<Word>, Word>) {
    return at + units;
  } else {
    if (std::is_constant_evaluated()) return at + units / static_cast<Units>(sizeof(Word));
    return static_cast<Word*>(static_cast<void*>(static_cast<std::byte*>(static_cast<void*>(at)) + units));
  }
}

/// The address of column 0 of a row whose Words begin at `first`, `words` Words right of column 0. That
/// column need not be in memory: the address is computed by integers, because pointers must not leave an
/// array.
template <class Word>
[[nodiscard]] constexpr Word* column_0_of(Word* first, std::size_t words) {
  if (std::is_constant_evaluated()) return first - words;
  return reinterpret_cast<Word*>(reinterpret_cast<std::uintptr_t>(first) - words * sizeof(Word));
}

/// True if `run` has pixels, and all of them lie within `bounds`.
[[nodiscard]] constexpr bool is_within(const Span& run, const Rect& bounds) {
  return run.count > 0 && run.y >= bounds.top && run.y < bounds.bottom && run.x >= bounds.left &&
         run.x <= bounds.right - run.count;
}

}  // namespace arcspan::detail
