// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/texture/plain/made_texture.hpp>

#include <vector>

namespace arcspan::tools {

/// Fills in the palette and the texels of a texture whose levels have more colours than its palette. The only
/// file of this project that knows libimagequant.
void choose_palette(const std::vector<RgbaImage>& levels, bool dither, MadeTexture& texture);

}  // namespace arcspan::tools
