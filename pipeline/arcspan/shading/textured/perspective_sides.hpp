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

/// The sides of the part of the texture that a pixel covers, roughly a rectangle. Along the line of equal
/// depth it is A/q texels of level 0 long, across it B/q^2, where q is the raw value of 1/w. A and B are the
/// same in the whole triangle. So towards the horizon a pixel covers much of a floor's length and little of
/// its width. The members and `log_q` are binary logarithms with 8 fraction bits.
struct PerspectiveSides {
  std::int32_t log_along;   ///< of A
  std::int32_t log_across;  ///< of B

  /// The logarithm of the longer side, where that of q is `log_q`.
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t log_longer(std::int32_t log_q) const {
    const std::int32_t along = log_along - log_q;
    const std::int32_t across = log_across - 2 * log_q;
    return along > across ? along : across;
  }
};

namespace detail {

/// log2(sqrt(a^2 + b^2)) from log2(a) and log2(b), 8 fraction bits; too low by at most 1/16. It is the
/// greater one and (2 - d)^2 / 8, where they differ by d, less than 2.
[[nodiscard]] constexpr std::int32_t log_of_hypotenuse(std::int32_t log_a, std::int32_t log_b) {
  const std::int32_t longer = log_a > log_b ? log_a : log_b;
  const std::int32_t to_512 = 512 - (2 * longer - log_a - log_b);
  return longer + (to_512 > 0 ? (to_512 * to_512) >> 11 : 0);
}

/// The changes of a quantity from a triangle's top to its middle and to its bottom, each reduced to 14 bits
/// and a sign: the true change is about that times 2^shift.
struct CornerChanges {
  std::int32_t to_middle;
  std::int32_t to_bottom;
  int shift;

  /// The values must differ by less than 2^31.
  constexpr CornerChanges(std::int32_t top, std::int32_t middle, std::int32_t bottom) {
    const std::int32_t m = wrap_sub(middle, top);
    const std::int32_t b = wrap_sub(bottom, top);
    shift = 18 - leading_zeros(low_magnitude(m) | low_magnitude(b) | 0x3FFFu);
    to_middle = m >> shift;
    to_bottom = b >> shift;
  }
  [[nodiscard]] constexpr bool are_zero() const { return (to_middle | to_bottom) == 0; }
  /// log2 of the cross product of these changes and others, 8 fraction bits: of twice the area of the
  /// triangle that has the two quantities as x and y. other.shift is left out.
  [[nodiscard]] constexpr std::int32_t log_cross(const CornerChanges& other) const {
    return low_log2(magnitude(to_middle * other.to_bottom - to_bottom * other.to_middle)) + 256 * shift;
  }
};

/// Returns the sides of the pixels of a triangle in perspective. All arrays are in the order top, middle,
/// bottom: `q` is 1/w, `u` and `v` are (u - u_origin)/w and (v - v_origin)/w, as TextureTriangle has them.
/// Raw values of u over those of q, times 2^u_bits, are texels of level 0; likewise v. `log_area` is log2 of
/// the mean of the texels that a pixel covers, from log_area_of().
///
/// With the gradients U of u/w and Q of 1/w, a step of one pixel along the line of equal depth changes u/w by
/// |U x Q| / |Q|, so u by that over q. Both gradients are cross products over the area of the triangle: the
/// area, and the shift of 1/w, cancel. A pixel covers AB / q^3 texels, on the mean AB / (q0 q1 q2): that
/// tells AB, and so B.
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
      slope + 256 * Subpixel::kFraction;  // positions are in 16ths of a pixel
  for (const std::int32_t corner : q) log_area += low_log2(static_cast<std::uint32_t>(corner));
  return {along, log_area - along};
}

}  // namespace detail
}  // namespace arcspan
