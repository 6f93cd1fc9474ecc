// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/shading/literature/linear_scalars.hpp>

namespace arcspan {

/// Duff's form of Phong shading (S0 [5], Duff 1979), for comparison: with N linear on the screen N·L, N·H and
/// N·V are linear and N·N is quadratic, so all are forward differences; a pixel then takes a root and one
/// division a scalar. The same picture as Phong but for rounding.
template <class Illumination>
struct Duff : LinearScalars<Illumination, RootAndDivision> {};

}  // namespace arcspan
