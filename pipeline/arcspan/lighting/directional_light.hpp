// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/material.hpp>
#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed_formats.hpp>

namespace arcspan {

/// A light so far away that its direction is the same for the whole object.
struct DirectionalLight {
  Direction towards;                            ///< unit vector to the light, in object space
  Coefficient strength = Coefficient::of(1.0);  ///< factor 1 / (d + K) (S1), 0...1
  /// The light's colour, white by default: S0's I(lambda), a factor 0...1 per channel.
  ChannelCoefficients colour{Coefficient::of(1.0), Coefficient::of(1.0), Coefficient::of(1.0)};
};

}  // namespace arcspan
