// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/prepare/row_start.hpp>

#include <cstdint>

namespace arcspan::literature {

/// Returns the start of the rest of a row, `count` pixels behind `start`.
[[nodiscard]] constexpr RowStart rest_of_row(const RowStart& start, std::int32_t count) {
  RowStart rest = start;
  rest.skipped += count;
  rest.column += count;
  return rest;
}

/// The pixels of a row (PiecewiseRun) that a walker starts anew after a number of pixels, because rounding
/// errors add up or because an arc ends: `walker.piece(start)` returns the pixels from `start` on, a
/// PixelRun with a length() in pixels.
template <class Walker>
class RowInPieces {
 public:
  constexpr RowInPieces(const Walker& walker, const RowStart& start) : walker_(&walker), start_(start) {}

  /// Starts the next piece and returns its length, at most `left`.
  template <class Lighting>
  [[nodiscard]] constexpr std::int32_t enter(const Lighting&, std::int32_t left) {
    piece_ = walker_->piece(start_);
    const std::int32_t length = piece_.length();
    if (length >= left) return left;
    start_ = rest_of_row(start_, length);
    return length;
  }
  template <class Lighting>
  [[nodiscard]] constexpr auto colour(const Lighting& lighting) const {
    return piece_.colour(lighting);
  }
  constexpr void next() { piece_.next(); }

 private:
  const Walker* walker_;
  RowStart start_;
  typename Walker::Piece piece_;
};

}  // namespace arcspan::literature
