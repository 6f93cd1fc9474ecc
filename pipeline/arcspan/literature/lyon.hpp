// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/linear_scalars.hpp>

namespace arcspan {

/// Divides scalars by |N|, with the Taylor series of 1/|N| in e = N·N - 1 up to e^2: 1 - e/2 + 3/8 e^2.
class TaylorRoot {
 public:
  /// `square` is N·N with 30 fraction bits, in 0...1 apart from rounding.
  constexpr explicit TaylorRoot(std::int32_t square) {
    const std::int32_t e = round_shift(wrap_sub(square, std::int32_t{1} << 30), 15);
    const std::int32_t three_squares = wrap_mul(3, round_shift(wrap_mul(e, e), 15));
    factor_ = (std::int32_t{1} << 15) - round_shift(e, 1) + round_shift(three_squares, 3);
  }

  /// scalar / |N|.
  [[nodiscard]] constexpr Cosine operator()(Linear scalar) const {
    const std::int32_t rounded = round_shift(scalar.raw(), Linear::kFraction);  // 15 fraction bits
    return Cosine::from_raw(wrap_mul(rounded, factor_));                        // |N·L| <= |N|, so it fits
  }

 private:
  std::int32_t factor_;  ///< 15 fraction bits, 1...1.875
};

/// Lyon's form of Phong shading (S0 [4]), for comparison: the scalars are divided by |N| with a series, with
/// no root and no division. The result is too small by 5/16 |e|^3, which is invisible when the vertex normals
/// are 20 degrees apart and 1.3 % when they are 60 degrees apart.
template <class Illumination>
struct Lyon : LinearScalars<Illumination, TaylorRoot> {};

}  // namespace arcspan
