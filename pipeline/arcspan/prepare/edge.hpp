// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <bit>
#include <cstdint>

namespace arcspan {

/// An edge on its way down the rows. `x` is where the row's centre line meets it, in pixels with 32 fraction
/// bits, plus 1/2, less 2^-20. Its upper word is then ceil(x - 1/2), the first column whose centre is not
/// left of the edge, and its complemented lower word is the distance from the edge to that centre.
///
/// This is exact: an edge's true x at a row centre is a multiple of 2^-19, since both coordinates have 4
/// fraction bits and dy fits 15; the step is short by less than 2^-32, over 2048 rows 2^-21.
struct EdgeWalk {
  std::int64_t x;
  std::int64_t step;

  [[nodiscard]] constexpr std::int32_t column() const { return static_cast<std::int32_t>(x >> 32); }

  /// Distance from the edge to the centre of column(), 16 fraction bits, 0...1.
  [[nodiscard]] constexpr std::uint32_t fraction() const { return ~static_cast<std::uint32_t>(x) >> 16; }

  /// The same with 32 fraction bits and without the bias: for rows so narrow that 16 bits of it say little.
  [[nodiscard]] constexpr std::uint32_t fine_fraction() const {
    const std::uint32_t biased = ~static_cast<std::uint32_t>(x);
    return biased < 4096u ? 0u : biased - 4096u;
  }

  constexpr void advance() { x += step; }
};

/// The part of an edge's way that depends on its two ends only: from `top` to `bottom`, top.y < bottom.y, so
/// that the two triangles of an edge walk it alike. `row` is the first row to be drawn, `offset` its centre's
/// distance below the top in 16ths of a row (0 <= offset < 2^15).
struct EdgeSetup {
  const RasterPosition* top;
  std::int32_t dy;      ///< height, 1...2^15 - 1 16ths of a row
  std::int32_t offset;  ///< centre of the first row below the top, 16ths of a row
  /// Reciprocal of dy. Unset on short right edges until make_inverse() is called, because only arcs need it
  /// there.
  Reciprocal inverse;

  constexpr void make_inverse() { inverse = nonzero_reciprocal(static_cast<std::uint32_t>(dy)); }
};

/// First row whose centre is at or below y: ceil(y - 1/2).
[[nodiscard]] constexpr std::int32_t first_row_at(std::int32_t y) { return (y + 7) >> 4; }

constexpr void make_edge_setup(const RasterPosition& top, const RasterPosition& bottom, std::int32_t row,
                               bool on_left, EdgeSetup& edge) {
  edge.top = &top;
  edge.dy = bottom.y - top.y;
  edge.offset = row * 16 + 8 - top.y;
  if (on_left || !kHasLongMultiply) edge.make_inverse();
}

/// offset / dy in 15 fraction bits, at most 1.
[[nodiscard]] constexpr Factor start_fraction(const EdgeSetup& edge) {
  const std::uint32_t product = static_cast<std::uint32_t>(edge.offset) * edge.inverse.mantissa;
  const std::uint32_t fraction = product >> (edge.inverse.exponent - Factor::kFraction);
  return Factor::from_raw(static_cast<std::int32_t>(fraction > 32768 ? 32768 : fraction));
}

namespace detail {

/// A quotient with 32 fraction bits, the last 16 of them apart, and whether nothing was left.
struct Quotient {
  std::uint32_t upper;
  std::uint32_t lower;
  bool exact;
};

/// dividend / divisor, rounded down, by schoolbook division; both below 2^15.
[[nodiscard]] constexpr Quotient divide(std::uint32_t dividend, std::uint32_t divisor) {
  if constexpr (kHasWideRegisters) {
    const std::uint64_t whole = std::uint64_t{dividend} << 32;
    const std::uint64_t quotient = whole / divisor;
    return {static_cast<std::uint32_t>(quotient >> 16), static_cast<std::uint32_t>(quotient & 0xFFFFu),
            whole == quotient * divisor};
  }
  const std::uint32_t upper = (dividend << 16) / divisor;
  const std::uint32_t rest = ((dividend << 16) - upper * divisor) << 16;
  const std::uint32_t lower = rest / divisor;
  return {upper, lower, rest == lower * divisor};
}

/// The same without a divide: each digit is estimated by the divisor's nonzero_reciprocal(), refined, off by
/// one at most, and put right by what it leaves.
[[nodiscard]] constexpr Quotient divide_by_reciprocal(std::uint32_t dividend, std::uint32_t divisor,
                                                      const Reciprocal& reciprocal) {
  const int zeros = 16 + 31 - reciprocal.exponent;
  const std::uint32_t inverse = refined_mantissa(divisor << zeros, reciprocal.mantissa);
  std::uint32_t rest = dividend;
  const auto digit = [&](int up) {
    // rest * 2^up / divisor = (rest << (up + zeros - 16)) * inverse >> 46, the product in two parts.
    const std::uint32_t scaled_rest = rest << up;
    std::uint32_t quotient = multiply_high(scaled_rest << 1, inverse) >> (31 - zeros);
    rest = scaled_rest - quotient * divisor;
    if (static_cast<std::int32_t>(rest) < 0) {
      --quotient;
      rest += divisor;
    } else if (rest >= divisor) {
      ++quotient;
      rest -= divisor;
    }
    return quotient;
  };
  const std::uint32_t whole = dividend < divisor ? 0 : digit(0);
  const std::uint32_t upper = (whole << 16) | digit(16);
  const std::uint32_t lower = digit(16);
  return {upper, lower, rest == 0};
}

}  // namespace detail

/// The exact walk of an edge (see EdgeWalk).
constexpr void make_edge_walk(const EdgeSetup& edge, const RasterPosition& bottom, EdgeWalk& walk) {
  const std::int32_t dx = bottom.x - edge.top->x;
  const auto magnitude = static_cast<std::uint32_t>(dx < 0 ? -dx : dx);
  const auto height = static_cast<std::uint32_t>(edge.dy);
  const detail::Quotient quotient = kHasLongMultiply
                                        ? detail::divide(magnitude, height)
                                        : detail::divide_by_reciprocal(magnitude, height, edge.inverse);
  const auto step = static_cast<std::int64_t>((std::uint64_t{quotient.upper} << 16) | quotient.lower);
  walk.step = dx < 0 ? -step - !quotient.exact : step;
  constexpr std::int64_t kBias = (std::int64_t{1} << 31) - (1 << 12);  // 1/2 - 2^-20
  walk.x = static_cast<std::int64_t>(static_cast<std::uint64_t>(edge.top->x) << 28) +
           (scaled(walk.step, static_cast<std::uint32_t>(edge.offset)) >> 4) + kBias;
}

}  // namespace arcspan
