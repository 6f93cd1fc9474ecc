// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/exchange.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace arcspan::detail {

/// sqrt(1 - (i / 16)^2) with 8 fraction bits, the largest rounded down.
inline constexpr std::array<std::uint8_t, 17> kHalfCircle{255, 255, 254, 252, 248, 243, 237, 230, 222,
                                                          212, 200, 186, 169, 149, 124, 89,  0};

/// Steps along an edge from row to row, as GapWalk does, and over the rows beyond both ends that ink with
/// round ends reaches. A row is the same wherever the walk begins, so that bands have equal pixels.
class InkWalk {
 public:
  /// The edge from `top` down to `bottom`, in the rows first ... end - 1 of `rows`; a steep one, or a flat
  /// one with x and y exchanged. The ink lies left (`side` -1) or right (0) of it, 0...4 pixels wide; with a
  /// `width` of 0 there are no rows beyond the ends.
  ARCSPAN_INLINE InkWalk(const RasterPosition& top, const RasterPosition& bottom, const RowRange& rows,
                         bool exchanged, std::int32_t side, std::int32_t width)
      : top_(top), bottom_(bottom), side_(side), width_(width), first_(first_row_at(top.y)) {
    const std::int32_t end = first_row_at(bottom.y);
    if (first_ >= end) return;  // no row's centre: the edges at both ends reach as far
    rows_ = static_cast<std::uint32_t>(end - first_);
    const bool is_round = has_round_ends();
    const std::int32_t beyond = is_round ? width : 0;
    row_ = first_ - beyond < rows.first ? rows.first : first_ - beyond;
    end_ = end + beyond > rows.end ? rows.end : end + beyond;
    if (done()) return;
    set_up_columns(top, bottom, first_, exchanged, walk_);
    set_across(is_round);
    move(row_ - first_);
  }

  [[nodiscard]] ARCSPAN_INLINE bool done() const { return row_ >= end_; }
  [[nodiscard]] ARCSPAN_INLINE std::int32_t row() const { return row_; }
  [[nodiscard]] ARCSPAN_INLINE std::int32_t column() const { return walk_.column(); }
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t fraction() const { return walk_.fraction(); }

  /// Where the ink ends in this row, in pixels left or right of the left side of column(), with 16 fraction
  /// bits. May be negative.
  [[nodiscard]] ARCSPAN_INLINE std::int32_t reach() const {
    const std::int32_t edge = static_cast<std::int32_t>(static_cast<std::uint32_t>(walk_.x) >> 16) - 32768;
    const std::int32_t straight = across_ + outward(edge);
    if (static_cast<std::uint32_t>(row_ - outer_first_) < rows_) [[likely]]
      return straight;
    const bool at_top = row_ < outer_first_;
    const std::int32_t end = outward(std::int32_t{at_top ? top_.x : bottom_.x} * 4096 - column() * 65536);
    const std::int32_t round = round_end(row_ * 16 + 8 - (at_top ? top_.y : bottom_.y), width_);
    if (is_beside()) return straight < end + round ? straight : end + round;
    // Where the circle lies beyond the straight line only in part, it has ended.
    return end - outward(edge) > round ? 0 : end + round;
  }

  ARCSPAN_INLINE void next() {
    ++row_;
    walk_.advance();
  }

 private:
  /// True if the edge has this row, false beyond its ends.
  [[nodiscard]] ARCSPAN_INLINE bool is_beside() const {
    return static_cast<std::uint32_t>(row_ - first_) < rows_;
  }

  /// Only where a steep edge meets a flat one ink would be missing without round ends. A short edge that
  /// leans by less than 1 : 2 hardly ever does; of a line of one pixel little is missing then.
  [[nodiscard]] ARCSPAN_INLINE bool has_round_ends() const {
    const std::int32_t dx = std::int32_t{bottom_.x} - top_.x;
    return width_ > 1 || rows_ >= 8 || 2 * (dx < 0 ? -dx : dx) > std::int32_t{bottom_.y} - top_.y;
  }

  /// `x` towards the side of the ink.
  [[nodiscard]] ARCSPAN_INLINE std::int32_t outward(std::int32_t x) const { return (x ^ side_) - side_; }

  /// Sets the width of the ink along a row: times sqrt(1 + s^2), which is 1 + 0.414 s^2 up to 1.4 %. The ends
  /// of its outer side lie s / sqrt(1 + s^2), about s - 0.29 s^2, of the width farther where the edge leans
  /// to. `is_round` is has_round_ends().
  ARCSPAN_INLINE void set_across(bool is_round) {
    const auto step = static_cast<std::int32_t>(walk_.step >> 17);  // 15 fraction bits, 1 or less
    const std::int32_t lean = outward(step);
    const std::uint32_t s = magnitude(lean);
    const std::uint32_t square = (s * s) >> 14;  // 16 fraction bits
    across_ = width_ * static_cast<std::int32_t>(65536 + (square * 27146 >> 16));
    const std::uint32_t along = s - (square * 9502 >> 16);
    const auto rows = static_cast<std::int32_t>((static_cast<std::uint32_t>(width_) * along + 16384) >> 15);
    outer_first_ = lean < 0 ? first_ + rows : first_ - rows;
    if (!is_round) outer_first_ = first_;
  }

  /// The breadth of a circle at a distance from its middle, in sixteenths of a row up to 16 `width`, with 16
  /// fraction bits.
  [[nodiscard]] ARCSPAN_OUTLINE static std::int32_t round_end(std::int32_t distance, std::int32_t width) {
    constexpr std::uint8_t kShares[] = {0, 255, 128, 86, 64};
    const std::int32_t i = (distance < 0 ? -distance : distance) * kShares[width] >> 8;
    return width * kHalfCircle[static_cast<std::size_t>(i > 16 ? 16 : i)] * 256;
  }

  /// Steps down by so many rows, or up.
  ARCSPAN_INLINE void move(std::int32_t rows) {
    if (rows < 0) {
      walk_.x -= scaled(walk_.step, static_cast<std::uint32_t>(-rows));
    } else {
      walk_.advance(rows);
    }
  }

  const RasterPosition top_;
  const RasterPosition bottom_;
  const std::int32_t side_;
  const std::int32_t width_;
  const std::int32_t first_;      ///< row of the edge
  std::uint32_t rows_ = 0;        ///< of the edge
  std::int32_t outer_first_ = 0;  ///< of the rows_ in which the outer side of the ink is straight
  std::int32_t row_ = 0;
  std::int32_t end_ = 0;
  std::int32_t across_ = 0;
  EdgeWalk walk_{};
};

}  // namespace arcspan::detail
