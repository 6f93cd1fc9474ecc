// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination_features.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace arcspan {

/// How the sum of several grey lights becomes a position in their ramp. All members have 15 fraction bits.
template <std::size_t Lights>
struct RampScale {
  /// The weighted sum of N·L at the end of the ramp, and its reciprocal. It depends on the material only, so
  /// that a change of the weights need not make the ramp.
  std::uint32_t range = 0;
  std::uint32_t inverse = 0;
  std::array<std::uint32_t, Lights> shares{};  ///< the lights' weights times `inverse`
};
/// Used for a single light, whose ramp is over N·L, and for coloured lights, which have none.
struct NoRampScale {};
template <std::size_t Lights, IlluminationFeatures Features>
using RampScaleFor =
    std::conditional_t<(Lights > 1 && !Features.coloured_lights), RampScale<Lights>, NoRampScale>;

}  // namespace arcspan
