// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/plain/made_texture.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>
#include <arcspan_tools/texture/plain/surface_texture.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

template <TexelColour C>
std::uint32_t shown_as(std::uint16_t stored) {
  return C::rgb565(stored) | C::alpha(stored) << 16;
}

/// A stored colour as SurfaceTexels have it.
std::uint32_t shown(std::uint16_t stored, unsigned alpha_bits) {
  if (alpha_bits == 0) return shown_as<OpaqueColour>(stored);
  return alpha_bits == 1 ? shown_as<Alpha1Colour>(stored) : shown_as<Alpha4Colour>(stored);
}

std::shared_ptr<const SurfaceTexture> of_levels(const std::vector<RgbaImage>& levels, const TextureSize& size,
                                                unsigned alpha_bits, const TextureSampler& sampler) {
  auto texture = std::make_shared<SurfaceTexture>();
  for (const RgbaImage& level : levels) {
    for (const Rgba8 c : level.pixels)
      texture->texels.push_back(shown(stored_colour(c, alpha_bits), alpha_bits));
  }
  static_cast<void>(Texture<SurfaceTexels>::make(texture->texels, size, texture->view));  // there are all
  texture->view = texture->view.with(sampler);
  return texture;
}

}  // namespace

RgbaImage shown_by(const FileMaterial& material, RgbaImage picture) {
  const auto least = std::lround(std::clamp(material.alpha_cutoff, 0.0, 2.0) * 255);
  for (Rgba8& c : picture.pixels) {
    if (material.alpha_mode == AlphaMode::kOpaque) c.a = 255;
    if (material.alpha_mode == AlphaMode::kMask) c.a = c.a >= least ? 255 : 0;
  }
  return picture;
}

RgbaImage picture_of(const FileMaterial& material) { return shown_by(material, material.texture->picture); }

std::shared_ptr<const SurfaceTexture> surface_texture(const RgbaImage& picture, unsigned alpha_bits,
                                                      const TextureSampler& sampler,
                                                      const IslandSize& islands) {
  const Size sides{nearest_side(picture.width), nearest_side(picture.height)};
  TextureSize size = texture_size(sides, 0, "texture");
  size.levels = levels_with_islands(size, islands);
  return of_levels(mip_levels(picture, size, sampler), size, alpha_bits, sampler);
}

std::shared_ptr<const SurfaceTexture> surface_texture_of(const FileMaterial& material, unsigned alpha_bits,
                                                         const IslandSize& islands) {
  std::vector<RgbaImage> levels{picture_of(material)};
  const auto& smaller = material.texture->smaller;
  if (!smaller) return surface_texture(levels[0], alpha_bits, material.sampler, islands);
  for (const RgbaImage& level : *smaller) levels.push_back(shown_by(material, level));
  const TextureSize size =
      texture_size({levels[0].width, levels[0].height}, static_cast<std::int32_t>(levels.size()), "texture");
  return of_levels(levels, size, alpha_bits, material.sampler);
}

const Texture<SurfaceTexels>& white_texture() {
  static const std::shared_ptr<const SurfaceTexture> kWhite = surface_texture(
      [] {
        RgbaImage white(8, 8);
        std::fill(white.pixels.begin(), white.pixels.end(), Rgba8{255, 255, 255, 255});
        return white;
      }(),
      0);
  return kWhite->view;
}

}  // namespace arcspan::tools
