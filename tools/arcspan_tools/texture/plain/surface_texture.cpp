// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/plain/made_texture.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>
#include <arcspan_tools/texture/plain/surface_texture.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {

RgbaImage picture_of(const FileMaterial& material) {
  RgbaImage picture = material.texture->picture;
  const auto least =
      static_cast<std::uint8_t>(std::lround(std::clamp(material.alpha_cutoff, 0.0, 1.0) * 255));
  for (Rgba8& c : picture.pixels) {
    if (material.alpha_mode == AlphaMode::kOpaque) c.a = 255;
    if (material.alpha_mode == AlphaMode::kMask) c.a = c.a >= least ? 255 : 0;
  }
  return picture;
}

std::shared_ptr<const SurfaceTexture> surface_texture(const RgbaImage& picture) {
  const Size sides{nearest_side(picture.width), nearest_side(picture.height)};
  const TextureSize size = texture_size(sides, 0, "texture");
  auto texture = std::make_shared<SurfaceTexture>();
  for (const RgbaImage& level : mip_levels(picture, size, PictureEdges::kRepeat)) {
    for (const Rgba8 c : level.pixels) texture->texels.push_back(stored_colour(c, 0));
  }
  static_cast<void>(Texture<DirectTexels<>>::make(texture->texels, size, texture->view));  // there are all
  return texture;
}

}  // namespace arcspan::tools
