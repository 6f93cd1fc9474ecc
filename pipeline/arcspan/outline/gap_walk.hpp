// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/outline/exchange.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

namespace arcspan::detail {

/// The slope of an outline, by which it cuts corners off pixels.
class GapSlope {
 public:
  GapSlope() = default;
  /// `slope` is |dx / dy|, 16 fraction bits, 0...1.
  explicit GapSlope(std::uint32_t slope)
      : slope_(slope), inverse_(slope >= kLeast ? (std::uint32_t{1} << 26) / slope : 0) {}

  /// The area in 32nds of the corner that an edge at this GapWalk::offset() cuts off the farther pixel. The
  /// edge leaves the nearer one at u = slope / 2 - |offset| before the row's end; the corner is
  /// u^2 / (2 slope).
  [[nodiscard]] ARCSPAN_INLINE std::uint32_t corner(std::int32_t offset) const {
    const std::int32_t beyond = static_cast<std::int32_t>(slope_ >> 1) - (offset < 0 ? -offset : offset);
    if (beyond <= 0) return 0;
    const auto u = static_cast<std::uint32_t>(beyond) >> 6;      // at most 2^9
    return (u * u * inverse_ + (std::uint32_t{1} << 25)) >> 26;  // the product is at most 2^28
  }

 private:
  /// Corners of steeper edges are below 1/64 pixel.
  static constexpr std::uint32_t kLeast = 8192;

  std::uint32_t slope_ = 0;
  std::uint32_t inverse_ = 0;  ///< 10 fraction bits; 0 below kLeast
};

/// Steps along an outline from pixel to pixel, by rows if it is steep, otherwise by columns. What is said of
/// rows here is true of columns if x and y are exchanged. The columns are those of the raster: column() is
/// the first pixel whose centre belongs to the right side of the edge.
class GapWalk {
 public:
  /// The edge from `top` down to `bottom`, in the rows first ... end - 1 of `rows`, which may be none.
  /// Columns are counted from `left`. `exchanged` says that x and y are.
  ARCSPAN_INLINE GapWalk(const RasterPosition& top, const RasterPosition& bottom, const RowRange& rows,
                         std::int32_t left, bool exchanged) {
    const std::int32_t first = first_row_at(top.y);
    const std::int32_t end = first_row_at(bottom.y);
    const std::int32_t begin = first < rows.first ? rows.first : first;
    end_ = end > rows.end ? rows.end : end;
    rows_ = end_ - begin;
    skipped_ = begin - rows.first;
    if (done()) return;
    set_up_columns(top, bottom, first, exchanged, walk_);
    if (begin != first) walk_.advance(begin - first);
    walk_.x -= std::int64_t{left} << 32;
  }

  [[nodiscard]] ARCSPAN_INLINE bool done() const { return rows_ <= 0; }
  /// The rows above the first one.
  [[nodiscard]] ARCSPAN_INLINE std::int32_t skipped() const { return skipped_; }
  [[nodiscard]] ARCSPAN_INLINE std::int32_t column() const { return walk_.column(); }
  /// The rows from the present one on, and the one behind the last.
  [[nodiscard]] ARCSPAN_INLINE std::int32_t rows() const { return rows_; }
  [[nodiscard]] ARCSPAN_INLINE std::int32_t end() const { return end_; }
  [[nodiscard]] ARCSPAN_INLINE GapSlope slope() const {
    return GapSlope(static_cast<std::uint32_t>(magnitude(walk_.step) >> 16));
  }

  /// The distance of the edge from the middle between the centres of column() - 1 and column(), to the right,
  /// in 2^-16 pixels: -2^15 + 1 ... 2^15.
  [[nodiscard]] ARCSPAN_INLINE std::int32_t offset() const {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(walk_.x) >> 16) - 32767;
  }

  ARCSPAN_INLINE void next() {
    --rows_;
    walk_.advance();
  }

 private:
  EdgeWalk walk_;
  std::int32_t rows_ = 0;  ///< from the present one on
  std::int32_t end_ = 0;
  std::int32_t skipped_ = 0;
};

}  // namespace arcspan::detail
