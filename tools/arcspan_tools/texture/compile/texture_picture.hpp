// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/image/image.hpp>
#include <arcspan_tools/texture/compile/make_texture.hpp>

namespace arcspan::tools {

/// The picture at the texture's size, the texture as the library draws it, and its mip levels below each
/// other. Small ones are magnified; transparent texels show squares.
[[nodiscard]] Image before_and_after(const TextureAndLevels& made);

}  // namespace arcspan::tools
