// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan_tools/texture/plain/islands.hpp>
#include <arcspan_tools/texture/plain/made_texture.hpp>
#include <arcspan_tools/texture/plain/mip_levels.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arcspan::tools {

/// How a texture is to be made of a picture.
struct TextureOptions {
  TextureFormat format;
  std::optional<Size> size{};  ///< the nearest powers of two, at most `most_side`, if unset
  std::int32_t most_side = 1 << TextureSize::kMostBits;
  std::int32_t levels = 1;              ///< 0 means all
  std::optional<IslandSize> islands{};  ///< limit the levels; those of opaque texels if unset
  TextureSampler sampler{};
  bool dither = false;  ///< mixes colours that the format lacks of neighbouring texels
  bool exact = false;   ///< refuses pictures whose colours would have to be reduced
};

/// A texture and the pictures that it was made of, one for each level, for comparisons.
struct TextureAndLevels {
  MadeTexture texture;
  std::vector<RgbaImage> levels;
};

/// Makes a texture of a picture. A palette that cannot hold all of its colours is chosen by libimagequant.
/// Throws a Failure about `subject` for sizes and numbers of levels that do not exist and, with `exact`, for
/// a picture of another size or with more colours than the palette has.
[[nodiscard]] TextureAndLevels make_texture(const RgbaImage& picture, const TextureOptions& options,
                                            const std::string& subject);

}  // namespace arcspan::tools
