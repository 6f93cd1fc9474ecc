// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/textured/piece_length.hpp>
#include <arcspan/shading/textured/texture_level.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/raster_vertex.hpp>

#include <cstdint>

/// How much of a texture a pixel covers in perspective, for the choice of the mip level.
namespace arcspan {

/// A pixel covers about a rectangle of the texture. With q the raw value of 1/w, its side along a line of
/// equal depth is A/q texels of level 0, the other B/q^2; A and B hold for the whole triangle. Towards the
/// horizon a pixel covers much of a floor's length and little of its width. All are binary logarithms with 8
/// fraction bits.
struct PerspectiveSides {
  std::int32_t log_along;   ///< of A
  std::int32_t log_across;  ///< of B

  /// The longer side.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t log_longer(std::int32_t log_q) const {
    const std::int32_t along = log_along - log_q;
    const std::int32_t across = log_across - 2 * log_q;
    return along > across ? along : across;
  }
};

namespace detail {

/// log2(sqrt(a^2 + b^2)) of log2(a) and log2(b), 8 fraction bits; too low by at most 1/16.
[[nodiscard]] constexpr std::int32_t log_of_hypotenuse(std::int32_t log_a, std::int32_t log_b) {
  const std::int32_t longer = log_a > log_b ? log_a : log_b;
  const std::int32_t to_512 = 512 - (2 * longer - log_a - log_b);
  return longer + (to_512 > 0 ? (to_512 * to_512) >> 11 : 0);
}

/// The changes of a quantity from a triangle's top to its middle and to its bottom, each as 14 bits and a
/// sign, to be multiplied by 2^shift.
struct CornerChanges {
  std::int32_t to_middle;
  std::int32_t to_bottom;
  int shift;

  /// The values differ by less than 2^31.
  constexpr CornerChanges(std::int32_t top, std::int32_t middle, std::int32_t bottom) {
    const std::int32_t m = wrap_sub(middle, top);
    const std::int32_t b = wrap_sub(bottom, top);
    shift = 18 - leading_zeros(low_magnitude(m) | low_magnitude(b) | 0x3FFFu);
    to_middle = m >> shift;
    to_bottom = b >> shift;
  }
  [[nodiscard]] constexpr bool are_zero() const { return (to_middle | to_bottom) == 0; }
  /// log2 of the cross product with other changes, without their shift: twice the area of the triangle whose
  /// corners have these two quantities as x and y. 8 fraction bits.
  [[nodiscard]] constexpr std::int32_t log_cross(const CornerChanges& other) const {
    return low_log2(magnitude(to_middle * other.to_bottom - to_bottom * other.to_middle)) + 256 * shift;
  }
};

/// Returns the sides of the pixels of a triangle in perspective. `q` is 1/w at its corners, `u` and `v` are
/// the relative u/w and v/w; `u_bits` and `v_bits` are the binary logarithms of the texels that a u or v of 1
/// has. `log_area` is log_area_of().
///
/// With the gradients U of u/w and Q of 1/w, a pixel along the line of equal depth changes u/w by
/// |U x Q| / |Q|, and u by that over q; the area of the triangle and the shift of 1/w cancel. The area of a
/// pixel is C / q^3, the mean over the triangle C / (q0 q1 q2).
template <class Frame>
[[nodiscard]] constexpr PerspectiveSides perspective_sides(const Frame& frame, const std::int32_t (&q)[3],
                                                           const std::int32_t (&u)[3],
                                                           const std::int32_t (&v)[3], int u_bits, int v_bits,
                                                           std::int32_t log_area) {
  const RasterPosition& a = frame.top->position;
  const RasterPosition& b = frame.middle->position;
  const RasterPosition& c = frame.bottom->position;
  const CornerChanges x(a.x, b.x, c.x);
  const CornerChanges y(a.y, b.y, c.y);
  CornerChanges depth(q[0], q[1], q[2]);
  if (depth.are_zero()) depth = y;  // any line is of equal depth: take the rows
  const std::int32_t slope = log_of_hypotenuse(x.log_cross(depth), y.log_cross(depth));
  const std::int32_t along =
      log_of_hypotenuse(CornerChanges(u[0], u[1], u[2]).log_cross(depth) + 256 * u_bits,
                        CornerChanges(v[0], v[1], v[2]).log_cross(depth) + 256 * v_bits) -
      slope + 256 * Subpixel::kFraction;
  for (const std::int32_t corner : q) log_area += low_log2(static_cast<std::uint32_t>(corner));
  return {along, log_area - along};
}

}  // namespace detail
}  // namespace arcspan
