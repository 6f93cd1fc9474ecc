// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/mesh/mesh_view.hpp>
#include <arcspan/shading/flat.hpp>
#include <arcspan/shading/gouraud.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/textured.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

/// Methods for cost_method.hpp that draw texels as `arcspan mesh` writes them, with mip levels.
namespace arcspan {

template <class Light>
using TexturedFlat = Textured<Flat<Light>, Palette8Texels<>>;
template <class Light>
using TexturedGreyGouraud = Textured<GreyGouraud<Light>, Palette8Texels<>>;
template <class Light>
using TexturedArc = Textured<Arc<Light>, Palette8Texels<>>;
template <class Light>
using TexturedDirectArc = Textured<Arc<Light>, DirectTexels<>>;
template <class Light>
using TexturedPal4Arc = Textured<Arc<Light>, Palette4Texels<>>;
template <class Light>
using TexturedGrayArc = Textured<Arc<Light>, GrayTexels>;
template <class Light>
using MaskedFlat = Textured<Flat<Light>, Palette8Texels<Alpha1Colour>>;
template <class Light>
using MaskedGreyGouraud = Textured<GreyGouraud<Light>, Palette8Texels<Alpha1Colour>>;
template <class Light>
using MaskedArc = Textured<Arc<Light>, Palette8Texels<Alpha1Colour>>;
template <class Light>
using TexturedBilinearArc =
    Textured<Arc<Light>, Palette8Texels<>, texel_light_of<Arc<Light>>(), TextureFilter::kBilinear>;

}  // namespace arcspan
