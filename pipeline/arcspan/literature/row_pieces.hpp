// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/literature/parabola.hpp>
#include <arcspan/literature/row_pixel.hpp>
#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/unroll.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

/// Rows of wide triangles. Along a row a scalar follows the great circle from its value A on the left edge to
/// its value B on the right edge. The row is halved until its pieces are narrow, by the value half-way,
///
///     M = (A + B) / (2 cos(psi/2)) = (A + B)/2 (1 + psi^2/8 + 5 psi^4/384 + ...)
///
/// (S0 eq. 2 at u = 1/2), and a piece is the parabola through its ends and its middle, which second
/// differences step.
namespace arcspan::literature {

/// Pieces of more than 2^kLongestPieceBits pixels are halved too, because rounding of the second difference
/// adds up to 2^-32 times the square of the length: 1.5e-5 over 256 pixels.
inline constexpr int kLongestPieceBits = 8;

/// The two ends of a row.
template <std::size_t Count>
struct RowEnds {
  std::array<Cosine, Count> left;
  std::array<Cosine, Count> right;
  Factor angle2;  ///< squared angle of the row in rad^2, at most 1.1
};

/// A piece of a row: its place among the pieces, and its first pixel.
struct RowPiece {
  std::uint32_t index;  ///< among 2^halvings pieces, from the left
  int halvings;
  std::uint32_t width;  ///< width of the row in pixels, `bits` fraction bits
  /// Distance in pixels from the piece's left end to the first pixel, `bits` fraction bits.
  std::uint32_t inside;
  int bits;
  /// Pixels from there to the end of the piece, at least 1; INT32_MAX in the last piece.
  std::int32_t length;
};

/// Returns the one of 2^halvings pieces of a row in which `start` lies.
[[nodiscard]] constexpr RowPiece piece_of_row(const RowPixel& start, int halvings) {
  // A row narrower than a pixel gives up fraction bits, so that products with the index fit.
  const int spare = start.bits == 16 ? 0 : 4;
  const std::uint32_t width =
      (start.width >> spare) | static_cast<std::uint32_t>((start.width >> spare) == 0);
  const std::uint32_t inside = start.inside >> spare;
  const int bits = start.bits - spare;
  const std::uint32_t last = (std::uint32_t{1} << halvings) - 1;
  std::uint32_t index = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = width >> halvings;
  while (index < last && inside >= end) {
    ++index;
    begin = end;
    end = ((index + 1) * width) >> halvings;
  }
  const std::uint32_t rest = index == last ? 0 : (end - inside + (std::uint32_t{1} << bits) - 1) >> bits;
  return {index,          halvings, width,
          inside - begin, bits,     index == last ? INT32_MAX : static_cast<std::int32_t>(rest)};
}

/// Returns the number of times that a row must be halved, so that the squared angle of its pieces is at most
/// `widest`, which is above 0.
[[nodiscard]] constexpr int halvings_of(Factor angle2, Factor widest, const RowPixel& start) {
  int halvings = 0;
  for (std::int32_t narrowed = angle2.raw(); narrowed > widest.raw(); narrowed >>= 2) ++halvings;
  if (start.bits == 16) {
    while ((start.width >> halvings) > (std::uint32_t{1} << (16 + kLongestPieceBits))) ++halvings;
  }
  return halvings;
}

/// Returns the quadruple sagitta of an arc divided by the mean of its two ends, 4 / cos(psi/2) - 4 = psi^2/2
/// + 0.0516 psi^4 + 0.0064 psi^6 of the squared angle psi^2 (15 fraction bits), at most 1.1. 17 fraction
/// bits, error below 1e-4. Fitted to the series.
[[nodiscard]] constexpr std::int32_t relative_sagitta4(std::int32_t angle2) {
  const std::int32_t fourth = wrap_mul(angle2, angle2) >> 15;  // 15 fraction bits
  // 0.0516 + 0.0064 psi^2 with 15 fraction bits
  const std::int32_t inner = 1692 + (wrap_mul(angle2, 209) >> 15);
  return wrap_shl(angle2, 1) + (wrap_mul(fourth, inner) >> 13);
}

/// The steps along a piece that all scalars share.
struct PieceSteps {
  Factor at;              ///< the piece's first column as a fraction of the piece
  std::int32_t mantissa;  ///< a pixel as a fraction of the piece: mantissa * 2^-exponent
  int exponent;           ///< 16...27
  std::int32_t square;    ///< the square of that: square * 2^-(2 exponent - 16)
  std::int32_t sagitta4;  ///< quadruple sagitta divided by the mean of the ends, 17 fraction bits
  int drop;               ///< low bits that slopes along the piece lose before they are multiplied

  /// Returns the steps along a piece with the squared angle `angle2`, from its first column.
  [[nodiscard]] static constexpr PieceSteps of(const RowPiece& piece, Factor angle2) {
    // From the piece's left end to its first column, in the unit of the width.
    const std::uint32_t distance = (piece.inside & ((std::uint32_t{1} << piece.bits) - 1)) << piece.halvings;
    const Reciprocal inverse = nonzero_reciprocal(piece.width);
    const std::uint32_t clamped = distance < piece.width ? distance : piece.width;
    // The shift moves the width to bit 31.
    const std::uint32_t normalised = clamped << (47 - inverse.exponent);
    PieceSteps steps;
    steps.at = Factor::from_raw(static_cast<std::int32_t>(((normalised >> 16) * inverse.mantissa) >> 16));
    steps.mantissa = static_cast<std::int32_t>(inverse.mantissa);
    // A piece shorter than a pixel has one pixel and takes no step; any exponent in range will do.
    const int exponent = inverse.exponent - piece.bits - piece.halvings;
    steps.exponent = exponent < 16 ? 16 : exponent;
    steps.square = ((steps.mantissa >> 1) * (steps.mantissa >> 1)) >> 14;
    steps.sagitta4 = relative_sagitta4(angle2.raw());
    // Up to 11 degrees slopes are below 1/4, otherwise below 1. Sharp highlights show what a slope loses.
    steps.drop = angle2 < Factor::of(0.04) ? 13 : 15;
    return steps;
  }
};

/// Returns the parabola at the first column of a piece from `p` to `q`. With the quadruple sagitta s it is
///
///     f(v) = p + v (q - p + s) - v^2 s,     v = 0...1 along the piece.
[[nodiscard]] constexpr Parabola parabola_of(const PieceSteps& steps, Cosine p, Cosine q) {
  const std::int32_t mean = wrap_add(p.raw() >> 1, q.raw() >> 1) >> 15;  // 15 fraction bits
  const std::int32_t s = wrap_mul(mean, steps.sagitta4) >> 2;            // 30 fraction bits, below 0.3
  const std::int32_t s_by_v = wrap_mul(s >> 13, steps.at.raw()) >> 2;
  const std::int32_t chord = wrap_add(wrap_sub(q.raw(), p.raw()), wrap_sub(s, s_by_v));  // below 1
  const std::int32_t slope = wrap_sub(chord, s_by_v);
  const std::int32_t change =  // of the first difference per pixel
      -round_shift(wrap_mul(s >> 14, steps.square), 2 * steps.exponent - 31);
  const int drop = steps.drop;
  Parabola f;
  f.x = p + Cosine::from_raw(wrap_mul(round_shift(chord, drop), steps.at.raw()) >> (15 - drop));
  f.d = Cosine::from_raw(
      wrap_add(wrap_mul(round_shift(slope, drop), steps.mantissa) >> (steps.exponent - drop), change >> 1));
  f.second_difference = Cosine::from_raw(change);
  return f;
}

/// Replaces the ends of a row by those of one of its pieces.
template <std::size_t Count>
constexpr void narrow_to(const RowPiece& piece, RowEnds<Count>& ends) {
  for (int level = piece.halvings - 1; level >= 0; --level) {
    const std::int32_t sagitta = relative_sagitta4(ends.angle2.raw()) >> 1;  // 18 fraction bits
    std::array<Cosine, Count>& replaced = ((piece.index >> level) & 1) != 0 ? ends.left : ends.right;
    unrolled<Count>([&](auto i) {
      const std::int32_t mean = wrap_add(ends.left[i].raw() >> 1, ends.right[i].raw() >> 1);
      replaced[i] = Cosine::from_raw(wrap_add(mean, round_shift(wrap_mul(mean >> 15, sagitta), 3)));
    });
    ends.angle2 = Factor::from_raw(ends.angle2.raw() >> 2);
  }
}

}  // namespace arcspan::literature
