// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/numbers/reciprocal.hpp>
#include <arcspan/target.hpp>
#include <arcspan/vertex/clip_transform.hpp>

#include <cstdint>

namespace arcspan {

/// A vertex on the screen. `x` and `y` are Subpixel values in 16 bits (4 fraction bits, y down, from the
/// raster origin: the viewport's middle pixel in column width / 2 and row height / 2, rounded down). `z` is
/// the depth, smaller is nearer.
struct RasterPosition {
  std::int16_t x;
  std::int16_t y;
  std::uint16_t z;

  friend constexpr bool operator==(const RasterPosition&, const RasterPosition&) = default;
};

/// Returns true if a vertex lies left of `left` or right of `right`, in sixteenths of a pixel from the raster
/// origin; left <= right.
[[nodiscard]] constexpr bool leaves_columns(std::int32_t left, std::int32_t right, const RasterPosition& a,
                                            const RasterPosition& b, const RasterPosition& c) {
  const std::uint32_t width = static_cast<std::uint32_t>(wrap_sub(right, left));
  const auto outside = [=](std::int32_t x) { return static_cast<std::uint32_t>(wrap_sub(x, left)) > width; };
  return outside(a.x) || outside(b.x) || outside(c.x);
}

/// One bit for each clip plane that a vertex is outside of: the near and the far plane, and the four sides of
/// the guard band.
enum ClipOutcode : std::uint8_t {
  kInside = 0,
  kOutsideNear = 1,
  kOutsideLeft = 2,
  kOutsideRight = 4,
  kOutsideTop = 8,
  kOutsideBottom = 16,
  kOutsideFar = 32,
};

/// The outcode of a clip-space vertex: ClipOutcode bits.
[[nodiscard]] constexpr std::uint8_t outcode(const ClipPosition& p, const WRange& w_range) {
  const auto inside = [&p](std::int32_t c) {
    return static_cast<std::uint32_t>(c + p.w) <= 2 * static_cast<std::uint32_t>(p.w);
  };
  // Behind the near plane the other planes are not tested, because w may be negative there.
  if (p.w < w_range.nearest) return kOutsideNear;
  if (inside(p.x) && inside(p.y) && p.w <= w_range.farthest) return kInside;
  return static_cast<std::uint8_t>((p.x < -p.w ? kOutsideLeft : 0) | (p.x > p.w ? kOutsideRight : 0) |
                                   (p.y < -p.w ? kOutsideTop : 0) | (p.y > p.w ? kOutsideBottom : 0) |
                                   (p.w > w_range.farthest ? kOutsideFar : 0));
}

/// The vertex on the screen: x and y are divided by w, rounded to the nearest Subpixel, and saturated at the
/// guard band. Requires p.w >= transform.near_w(). Sets `near_over_w` to near_w() / w, 29 fraction bits.
[[nodiscard]] ARCSPAN_INLINE inline RasterPosition project(const ClipPosition& p,
                                                           const ClipTransform& transform,
                                                           std::int32_t& near_over_w) {
  // c / w = (c << zeros) / (w << zeros). `c` is shifted by one bit less, which keeps its sign.
  const auto w = static_cast<std::uint32_t>(p.w);
  const int zeros = leading_zeros(w | 1u);
  const std::uint32_t mantissa = detail::wide_reciprocal_mantissa(w << zeros);
  const auto inverse = static_cast<std::int32_t>(mantissa - (mantissa >> 31));  // at most 2^31 - 1
  const auto over_w = [=](std::int32_t c) { return multiply_high(wrap_shl(c, zeros - 1), inverse); };
  const auto screen = [&](std::int32_t c, std::int32_t rounding) {
    const std::int32_t snapped = wrap_add(over_w(c), rounding) >> (29 - kGuardBits - Subpixel::kFraction);
    return static_cast<std::int16_t>(clamped_to_bits<kGuardBits + Subpixel::kFraction + 1>(snapped));
  };
  near_over_w = over_w(transform.near_w());
  return {screen(p.x, transform.rounding(0)), screen(p.y, transform.rounding(1)),
          transform.depth(near_over_w)};
}

/// project() where near/w is not needed.
[[nodiscard]] inline RasterPosition project(const ClipPosition& p, const ClipTransform& transform) {
  std::int32_t near_over_w;
  return project(p, transform, near_over_w);
}

/// Sets `position` to project() and returns near_over_w. At -Os a function whose arguments fit registers.
ARCSPAN_OUTLINE_IF_TIGHT inline std::int32_t project_to(std::int32_t x, std::int32_t y, std::int32_t w,
                                                        const ClipTransform& transform,
                                                        RasterPosition& position) {
  std::int32_t near_over_w;
  position = project({x, y, w}, transform, near_over_w);
  return near_over_w;
}

}  // namespace arcspan
