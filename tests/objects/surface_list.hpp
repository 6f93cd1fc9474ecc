// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/pixel/fog.hpp>
#include <arcspan/shading/grey_gouraud.hpp>
#include <arcspan/shading/surface/arc.hpp>
#include <arcspan/shading/textured/environment_map.hpp>
#include <arcspan/shading/textured/textured.hpp>
#include <arcspan/shading/vertex_coloured.hpp>
#include <arcspan/shading/with_operation.hpp>

/// The illuminations, and the surfaces with textures and operations, whose objects are checked.
namespace arcspan {

using Blinn1 = Illumination<1, Highlight::kBlinn>;
using Blinn4 = Illumination<4, Highlight::kBlinn>;
using Phong1 = Illumination<1, Highlight::kPhong>;
using Phong4 = Illumination<4, Highlight::kPhong>;
using Coloured4 = Illumination<4, Highlight::kPhong, IlluminationFeatures{.coloured_lights = true}>;

using Window =
    WithOperation<WithOperation<Textured<Arc<Phong1>, Palette8Texels<Alpha4Colour>>, Fogged>, Opacity<>>;
using Sign = Textured<Unlit, Palette4Texels<Alpha1Colour>>;
using Poster =
    Textured<Unlit, DirectTexels<>, TexelLight::kNone, TextureFilter::kBilinear, TextureBorders::kOfTexture>;
using Wall = Textured<GreyGouraud<Blinn4>, DirectTexels<>>;
using Stage = Textured<Gouraud<Blinn1>, GrayTexels, TexelLight::kColoured>;
using Chrome = Arc<EnvironmentMap<DirectTexels<>>>;
using Glass = WithOperation<VertexColoured<Blinn1>, Opacity<Blend::kMultiply>>;
using Ghost = WithOperation<UnlitVertexColoured, ScreenDoor>;

}  // namespace arcspan
