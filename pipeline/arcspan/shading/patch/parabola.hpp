// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/shading/patch/patch.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A scalar at a pixel, its first difference and its second difference along the row.
struct Parabola {
  Cosine x;
  Cosine d;
  Cosine second_difference;
};

/// Returns a scalar of a patch at a row's first column. `p` is the distance in pixels from the left edge to
/// that column: 16 fraction bits, 0 or more and below 1.
[[nodiscard]] ARCSPAN_INLINE constexpr Parabola parabola_from_edge(const PatchScalar& scalar,
                                                                   std::uint32_t p) {
  // With b the second difference: f(p) = at + p slope + p^2 b / 2,  f(p + 1) - f(p) = slope + p b + b / 2.
  const Cosine second_difference = scalar.second_difference;
  const Cosine slope = scalar.left.slope;
  const Cosine slope_change =
      Cosine::from_raw(wrap_mul(scalar.parts.coarse(second_difference), static_cast<std::int32_t>(p >> 8)));
  const Cosine mean = slope + Cosine::from_raw(slope_change.raw() >> 1);
  const Cosine inside = Cosine::from_raw(wrap_mul(mean.raw() >> 13, static_cast<std::int32_t>(p >> 3)));
  return {scalar.left.at + inside,
          slope + slope_change + Cosine::from_raw(scalar.parts.half(second_difference)), second_difference};
}

}  // namespace arcspan
