// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/numbers/direction.hpp>
#include <arcspan/numbers/fixed_formats.hpp>

namespace arcspan {

/// A light so far away that its direction is the same for the whole object.
struct DirectionalLight {
  Direction towards;                            ///< unit vector to the light, in object space
  Coefficient strength = Coefficient::of(1.0);  ///< factor 1 / (d + K) (S1), 0...1
};

}  // namespace arcspan
