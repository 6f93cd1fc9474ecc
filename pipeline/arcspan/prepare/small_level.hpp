// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/integer.hpp>
#include <arcspan/prepare/small_triangle.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

namespace arcspan {

/// A 16-bit attribute that is linear on a small triangle, in barycentric coordinates b and c of the middle
/// and the bottom vertex: at + b (middle - at) + c (bottom - at).
class SmallLevel {
 public:
  /// Values are 0...65280. `half` is added, so that dropping bits rounds. A pixel is off by less than 2^22:
  /// 3/4 of a step of 2^-15 for each of two coordinates and 14 pixels, and 1 where the row begins. So with a
  /// `half` of at least 2^22 none is below 0.
  constexpr void prepare(std::int32_t top, std::int32_t middle, std::int32_t bottom, FullLinear half,
                         const SmallTriangle& triangle) {
    at_ = FullLinear::from_raw(wrap_shl(top, FullLinear::kFraction)) + half;
    to_middle_ = middle - top;
    to_bottom_ = bottom - top;
    step = FullLinear::from_raw(change(triangle.d_middle, triangle.d_bottom));
  }
  /// The value at the coordinates b and c, 16 fraction bits.
  [[nodiscard]] ARCSPAN_INLINE constexpr FullLinear at(std::int32_t b, std::int32_t c) const {
    return at_ + FullLinear::from_raw(change(b, c));
  }

  FullLinear step;  ///< per pixel

 private:
  [[nodiscard]] ARCSPAN_INLINE constexpr std::int32_t change(std::int32_t b, std::int32_t c) const {
    return wrap_add(wrap_mul(to_middle_, b >> 1), wrap_mul(to_bottom_, c >> 1));
  }

  FullLinear at_;  ///< at the top vertex
  std::int32_t to_middle_;
  std::int32_t to_bottom_;
};

}  // namespace arcspan
