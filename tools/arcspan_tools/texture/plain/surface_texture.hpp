// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture.hpp>

#include <arcspan_tools/mesh/plain/model.hpp>
#include <arcspan_tools/texture/plain/islands.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace arcspan::tools {

/// The picture of a material's texture, or a smaller level of it, as a surface shows it: opaque if it is
/// neither masked nor blended; if masked, pixels are opaque or fully transparent.
[[nodiscard]] RgbaImage shown_by(const FileMaterial& material, RgbaImage picture);
[[nodiscard]] RgbaImage picture_of(const FileMaterial& material);

/// Texels for drawing on this machine: what the library shows of a stored texel, whatever its format. Thus
/// one instantiation draws textures with any alpha.
struct SurfaceTexels {
  /// The 5-6-5 pixel in the lower half, the opacity of 0...16 in the upper one.
  struct ColourFormat {
    static constexpr unsigned kAlphaBits = 4;
    [[nodiscard]] static constexpr std::uint16_t rgb565(std::uint32_t stored) {
      return static_cast<std::uint16_t>(stored & 0xFFFFu);
    }
    [[nodiscard]] static constexpr std::uint32_t alpha(std::uint32_t stored) { return stored >> 16; }
  };
  using Word = std::uint32_t;
  static constexpr unsigned kBits = 32;
  static constexpr std::size_t kPaletteSize = 0;
  [[nodiscard]] static constexpr std::uint32_t stored(const Word* words, const std::uint16_t*,
                                                      std::uint32_t index) {
    return words[index];
  }
};

/// A texture for drawing on this machine.
struct SurfaceTexture {
  std::vector<std::uint32_t> texels;
  Texture<SurfaceTexels> view;  ///< of `texels`
};

/// The texture that `arcspan mesh` makes of a picture with direct texels and `alpha_bits` (0, 1 or 4), in the
/// size that is nearest to it, with all mip levels in which `islands` have two texels.
[[nodiscard]] std::shared_ptr<const SurfaceTexture> surface_texture(const RgbaImage& picture,
                                                                    unsigned alpha_bits,
                                                                    const TextureSampler& sampler = {},
                                                                    const IslandSize& islands = {});

/// The texture of a material: with the mip levels that its file stores, if it stores them, else as
/// surface_texture() makes it of the picture.
[[nodiscard]] std::shared_ptr<const SurfaceTexture> surface_texture_of(const FileMaterial& material,
                                                                       unsigned alpha_bits,
                                                                       const IslandSize& islands);

/// A texture whose texels are white and opaque.
[[nodiscard]] const Texture<SurfaceTexels>& white_texture();

}  // namespace arcspan::tools
