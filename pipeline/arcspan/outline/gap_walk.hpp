// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/outline/exchange.hpp>
#include <arcspan/pixel/sink.hpp>
#include <arcspan/prepare/edge.hpp>
#include <arcspan/prepare/linear.hpp>
#include <arcspan/prepare/triangle.hpp>
#include <arcspan/span/depth.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/placement.hpp>
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
  [[nodiscard]] std::uint32_t corner(std::int32_t offset) const {
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
  /// The edge from `top` down to `bottom`, in the rows first ... end - 1 of `rows`, which may be none. `steps
  /// columns` says that x and y are exchanged.
  GapWalk(const RasterPosition& top, const RasterPosition& bottom, const RowRange& rows, bool exchanged) {
    const std::int32_t first = first_row_at(top.y);
    const std::int32_t end = first_row_at(bottom.y);
    row_ = first < rows.first ? rows.first : first;
    end_ = end > rows.end ? rows.end : end;
    if (row_ >= end_) return;
    set_up_outline(top, bottom, first, exchanged, walk_, z_);
    if (row_ != first) {
      walk_.advance(row_ - first);
      z_.at += Linear::from_raw(wrap_mul(z_.step.raw(), row_ - first));
    }
  }

  [[nodiscard]] bool done() const { return row_ >= end_; }
  [[nodiscard]] std::int32_t row() const { return row_; }
  [[nodiscard]] std::int32_t column() const { return walk_.column(); }
  [[nodiscard]] std::uint16_t depth() const { return depth_of(z_.at); }
  [[nodiscard]] GapSlope slope() const {
    const std::int64_t slope = (walk_.step < 0 ? -walk_.step : walk_.step) >> 16;
    return GapSlope(slope > 65536 ? 65536u : static_cast<std::uint32_t>(slope));
  }

  /// The distance of the edge from the middle between the centres of column() - 1 and column(), to the right,
  /// in 2^-16 pixels: -2^15 + 1 ... 2^15.
  [[nodiscard]] std::int32_t offset() const { return 32768 - static_cast<std::int32_t>(walk_.fraction()); }

  void next() {
    ++row_;
    walk_.advance();
    z_.at += z_.step;
  }

 private:
  EdgeWalk walk_{};
  BasicLinearEdge<Linear> z_{};
  std::int32_t row_ = 0;
  std::int32_t end_ = 0;
};

}  // namespace arcspan::detail
