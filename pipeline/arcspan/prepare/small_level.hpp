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
  /// Values are 0...65280. `half` is added, so that dropping bits rounds. The raw value of a pixel is off by
  /// less than 2^18: by 2^16 for each coordinate, cut to 15 bits, and by 2^16 for the reciprocal. So with a
  /// `half` of 2^18 or more none is below 0.
  constexpr void prepare(std::int32_t top, std::int32_t middle, std::int32_t bottom, FullLinear half,
                         const SmallTriangle& triangle) {
    at_ = FullLinear::from_raw(wrap_shl(top, FullLinear::kFraction)) + half;
    to_middle_ = middle - top;
    to_bottom_ = bottom - top;
    step = FullLinear::from_raw(wrap_shl(triangle.per_pixel(to_middle_, to_bottom_),
                                         FullLinear::kFraction - SmallTriangle::kStepBits));
  }
  /// The value at the coordinates b and c, which have 16 fraction bits.
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
