// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>

#include <cstdint>

/// How many pixels of a row in perspective may be linear (decision 29).
namespace arcspan {

/// Pixels of the longest piece. The table of their reciprocals has as many entries.
inline constexpr std::int32_t kLongestPiece = 128;

namespace detail {

/// Returns a lower bound of the binary logarithm of v > 0, 8 fraction bits; it is too low by at most
/// kLogError.
[[nodiscard]] constexpr std::int32_t low_log2(std::uint32_t v) {
  const int zeros = leading_zeros(v | 1u);
  return (31 - zeros) * 256 + static_cast<std::int32_t>(((v << zeros) >> 23) & 0xFFu);
}
inline constexpr std::int32_t kLogError = 24;  // log2(1 + m) - m is at most 0.0861, and 1/256 is cut off

/// The largest |s' - f q'| q of a triangle's vertices, where f = s/q: the change of f along a row times q^2,
/// with the fraction bits of 2 Linear less 28. Along a row it is constant, over the triangle linear.
struct PerspectiveSlope {
  std::int32_t ds;  ///< raw gradients
  std::int32_t dq;
  std::uint32_t most = 0;

  /// Adds a vertex: f with 28 fraction bits, q as Linear.
  constexpr void add(std::int32_t f, std::int32_t q) {
    const std::int32_t part = multiply_high(dq, wrap_shl(f, 2)) * 4;
    const std::int32_t slope = wrap_sub(ds, part);
    const std::uint32_t magnitude = static_cast<std::uint32_t>(slope < 0 ? -slope : slope) + 4;
    const std::uint32_t product = multiply_high(magnitude, static_cast<std::uint32_t>(q) << 4) + 1;
    if (product > most) most = product;
  }
};

/// The binary logarithm of the most pixels by which perspective may move a texel. Where texels are larger
/// than that, half a texel would be more.
inline constexpr int kLogMostPixels = 1;

struct PieceLength {
  std::uint8_t pixels;
  std::int32_t pixel_q;  ///< from this q on a piece of so many pixels stays within kLogMostPixels
};

/// Returns the piece over which u and v may be linear at the least q of a triangle, with 0 pixels if that is
/// less than one: the error, n^2/4 |q'| |s' q - s q'| / q^3 texels, stays below 0.45, and in pixels, n^2/4
/// |q'| / q, below 2^kLogMostPixels. `u` and `v` are the slopes; `u_bits` and `v_bits` the binary logarithms
/// of the texels that a relative u or v of 1 has.
[[nodiscard]] constexpr PieceLength piece_length(std::int32_t least_q, const PerspectiveSlope& u,
                                                 const PerspectiveSlope& v, int u_bits, int v_bits) {
  constexpr auto kLongest = static_cast<std::uint8_t>(kLongestPiece);
  const std::uint32_t dq = static_cast<std::uint32_t>(u.dq < 0 ? -u.dq : u.dq);
  if (dq == 0) return {kLongest, 0};
  const std::int32_t along_u = low_log2(u.most) + 256 * u_bits;
  const std::int32_t along_v = low_log2(v.most) + 256 * v_bits;
  const std::int32_t slope = (along_u > along_v ? along_u : along_v) + kLogError;
  constexpr std::int32_t kLimit = 217;  // log2(4 * 0.45), 8 fraction bits
  // All as Linear; the product of the slope is 2^-28 of what it stands for.
  const std::int32_t square = kLimit + 3 * low_log2(static_cast<std::uint32_t>(least_q)) - 256 * 28 -
                              (low_log2(dq) + kLogError) - slope;
  const std::int32_t of_pixels =
      256 * (2 + kLogMostPixels) + low_log2(static_cast<std::uint32_t>(least_q)) - low_log2(dq) - kLogError;
  const std::int32_t room = of_pixels > square ? (of_pixels - square) >> 8 : 0;
  const std::int32_t pixel_q = room > 31 ? 0 : least_q >> room;
  const std::int32_t log = (square < of_pixels ? square : of_pixels) >> 1;
  if (log < 0) return {0, pixel_q};
  if (log >= 7 * 256) return {kLongest, pixel_q};
  // 2^m is at least 1 + m ln 2, and at least 1 + m - 0.0861.
  const std::int32_t m = log & 255;
  const std::int32_t tangent = (m * 177) >> 8;
  const std::int32_t chord = m - kLogError;
  const std::int32_t length = (256 + (tangent > chord ? tangent : chord)) << (log >> 8) >> 8;
  return {static_cast<std::uint8_t>(length), pixel_q};
}

}  // namespace detail
}  // namespace arcspan
