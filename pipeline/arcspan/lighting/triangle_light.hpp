// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/fixed_formats.hpp>
#include <arcspan/numbers/integer.hpp>
#include <arcspan/target.hpp>

#include <cstdint>

/// The light that reaches a triangle, as an illumination finds it for a shading method.
namespace arcspan {

/// The squared chord of 60 degrees. Beyond it light_over() has no bounds.
inline constexpr std::uint32_t kWidestBounded = std::uint32_t{1} << 28;
/// The squared chord of 33 degrees, up to which quadratic surfaces have a series.
inline constexpr std::uint32_t kWidestQuadratic = 86613079u;

/// The parts of an illumination that reach a triangle.
enum class LightReach : std::uint8_t {
  kNone,       ///< no light: ambient colour alone
  kDiffuse,    ///< no highlight above half the tolerance
  kHighlight,  ///< all
};

/// The result of light_over(): bounds over all normals of a triangle.
struct TriangleLight {
  LightReach reach;
  bool linear;       ///< planes are within the tolerance
  std::uint8_t lit;  ///< kDiffuse: the lights that diffuse_scalar() sums up, a bit each
  /// By what scalars of a linear surface are lengthened: s/12, about half of the largest lengthening().
  std::int32_t lift;
  /// The squared chord up to which quadratic surfaces are within the tolerance, 28 fraction bits.
  std::uint32_t quadratic_limit;
};

/// A channel of diffuse light as a linear function of its scalar, in 256ths of an 8-bit step.
struct LinearLevel {
  std::int32_t dark;  ///< without light
  std::int32_t rise;  ///< what a scalar of 1 adds, at most 2^18
  bool is_gradual;    ///< false for light in steps, or too dim for two colours in a sixteenth of its ramp

  /// The level at a scalar, below 0 and above 65280 where light is less than none or more than full.
  [[nodiscard]] constexpr std::int32_t at(Cosine scalar) const {
    return dark + multiply_high(scalar.raw(), wrap_shl(rise, 32 - Cosine::kFraction));
  }
};

}  // namespace arcspan
