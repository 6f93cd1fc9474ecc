// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture.hpp>

#include <arcspan_tools/image/rgba_image.hpp>
#include <arcspan_tools/support/parse.hpp>

#include <string>
#include <vector>

namespace arcspan::tools {

/// The power of two from 8 to 1024 that is nearest to a side of a picture.
[[nodiscard]] std::int32_t nearest_side(std::int32_t side);

/// The size of a texture with these sides. `levels` is their number, 0 for all. Throws a Failure about
/// `subject` for sides that are no powers of two from 8 to 1024, and for more levels than there are.
[[nodiscard]] TextureSize texture_size(const Size& sides, std::int32_t levels, const std::string& subject);

/// The levels of a texture: the picture at its size, and its halves. Pixels are averaged in linear light,
/// weighted by their opacity. Beyond the edges they continue as `sampler` says.
[[nodiscard]] std::vector<RgbaImage> mip_levels(const RgbaImage& picture, const TextureSize& size,
                                                const TextureSampler& sampler);

}  // namespace arcspan::tools
