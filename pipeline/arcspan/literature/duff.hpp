// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/lighting/illumination.hpp>
#include <arcspan/literature/linear_scalars.hpp>

namespace arcspan {

/// Duff's form of Phong shading (S0 [5], Duff 1979), for comparison. With N linear on the screen, N·L, N·H
/// and N·V are linear and N·N is quadratic, so all are stepped by forward differences. Each pixel takes one
/// root and one division per scalar. Apart from rounding the picture is that of Phong.
template <class Illumination>
struct Duff : LinearScalars<Illumination, RootAndDivision> {};

}  // namespace arcspan
