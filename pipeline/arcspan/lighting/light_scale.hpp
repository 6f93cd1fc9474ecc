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
/// For each of several coloured lights, and red, green and blue: the factors by which N·L and the highlight
/// become parts of a ChannelLight.
template <std::size_t Lights>
struct ChannelScale {
  /// For N·L: the diffuse coefficient times the light's weight, in 8-bit steps with 5 fraction bits.
  std::array<std::array<std::uint32_t, 3>, Lights> tints{};
  /// For the highlight: how many steps of a 5-6-5 pixel one 8-bit step of HighlightTable::value() becomes,
  /// with the light's weight and the channel's share of the highlight, 15 fraction bits.
  std::array<std::array<std::uint32_t, 3>, Lights> shines{};
};
/// Used for a single light, whose ramp is over N·L.
struct NoScale {};
template <std::size_t Lights, IlluminationFeatures Features>
using ScaleFor =
    std::conditional_t<Lights == 1, NoScale,
                       std::conditional_t<Features.coloured_lights, ChannelScale<Lights>, RampScale<Lights>>>;

}  // namespace arcspan
