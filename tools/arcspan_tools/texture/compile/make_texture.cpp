// SPDX-License-Identifier: MIT
#include <arcspan_tools/support/failure.hpp>
#include <arcspan_tools/texture/compile/choose_palette.hpp>
#include <arcspan_tools/texture/compile/make_texture.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace arcspan::tools {
namespace {

using MipLevels = std::vector<RgbaImage>;

/// Bayer's matrix of 8x8 thresholds, 0...63: the bits of x ^ y and y, interleaved from the lowest on.
int threshold(std::int32_t x, std::int32_t y) {
  int value = 0;
  for (int bit = 0; bit < 3; ++bit) {
    value = value * 4 + 2 * (((x ^ y) >> bit) & 1) + ((y >> bit) & 1);
  }
  return value;
}

/// A channel plus less than half of a step of `most` + 1 ones, in either direction.
std::uint8_t dithered(std::uint8_t value, int most, int threshold) {
  const int shift = ((2 * threshold - 63) * 255) / (128 * most);
  return static_cast<std::uint8_t>(std::clamp(value + shift, 0, 255));
}

Rgba8 dithered(Rgba8 c, unsigned alpha_bits, int threshold) {
  const int most = alpha_bits == 4 ? 15 : 31;
  const int green = alpha_bits == 0 ? 63 : most;
  return {dithered(c.r, most, threshold), dithered(c.g, green, threshold), dithered(c.b, most, threshold),
          c.a};
}

void store_colours(const MipLevels& levels, bool dither, MadeTexture& texture) {
  const unsigned alpha_bits = texture.format.alpha_bits;
  for (const RgbaImage& level : levels) {
    for (std::int32_t y = 0; y < level.height; ++y) {
      for (std::int32_t x = 0; x < level.width; ++x) {
        const Rgba8 c = level.at(x, y);
        texture.texels.push_back(
            stored_colour(dither ? dithered(c, alpha_bits, threshold(x, y)) : c, alpha_bits));
      }
    }
  }
}

void store_greys(const MipLevels& levels, bool dither, MadeTexture& texture) {
  for (const RgbaImage& level : levels) {
    for (std::int32_t y = 0; y < level.height; ++y) {
      for (std::int32_t x = 0; x < level.width; ++x) {
        const Rgba8 c = level.at(x, y);
        const std::uint8_t grey = luma({c.r, c.g, c.b});
        texture.texels.push_back(dither ? dithered(grey, 31, threshold(x, y)) : grey);
      }
    }
  }
}

/// Makes the palette of all colours, as the format stores them, unless they are more than it holds, or
/// dithering could mix one that it does not have. Returns their number.
std::size_t store_all_colours(const MipLevels& levels, bool dither, MadeTexture& texture) {
  const unsigned alpha_bits = texture.format.alpha_bits;
  const std::size_t most = texture_binary::palette_size(texture.format.layout);
  std::map<std::uint16_t, std::uint16_t> index_of;
  bool kept = true;
  for (const RgbaImage& level : levels) {
    for (const Rgba8 c : level.pixels) {
      const std::uint16_t stored = stored_colour(c, alpha_bits);
      index_of.emplace(stored, 0);
      kept = kept && drawn_colour(stored, alpha_bits) == c;
    }
  }
  if (index_of.size() > most || (dither && !kept)) return index_of.size();
  for (auto& [colour, index] : index_of) {
    index = static_cast<std::uint16_t>(texture.palette.size());
    texture.palette.push_back(colour);
  }
  for (const RgbaImage& level : levels) {
    for (const Rgba8 c : level.pixels) {
      texture.texels.push_back(index_of.at(stored_colour(c, alpha_bits)));
    }
  }
  return index_of.size();
}

void store_indices(const MipLevels& levels, const TextureOptions& options, MadeTexture& texture,
                   const std::string& subject) {
  const std::size_t most = texture_binary::palette_size(texture.format.layout);
  const std::size_t colours = store_all_colours(levels, options.dither, texture);
  if (colours > most && options.exact) {
    throw Failure(subject, "has " + std::to_string(colours) + " colours, and " + options.format.name +
                               " holds " + std::to_string(most));
  }
  if (texture.palette.empty()) choose_palette(levels, options.dither, texture);
  texture.palette.resize(most, texture.palette.back());
}

Size wanted_size(const RgbaImage& picture, const TextureOptions& options) {
  if (options.size) return *options.size;
  return {std::min(nearest_side(picture.width), options.most_side),
          std::min(nearest_side(picture.height), options.most_side)};
}

bool is_opaque(Rgba8 c) { return c.a == 255; }

}  // namespace

TextureAndLevels make_texture(const RgbaImage& picture, const TextureOptions& options,
                              const std::string& subject) {
  const TextureSize size = texture_size(wanted_size(picture, options), options.levels, subject);
  if (options.exact && (picture.width != 1 << size.width_bits || picture.height != 1 << size.height_bits)) {
    throw Failure(subject, "is " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                               " and would have to be resized");
  }
  RgbaImage source = picture;
  if (options.format.alpha_bits == 0 && !std::all_of(source.pixels.begin(), source.pixels.end(), is_opaque)) {
    for (Rgba8& c : source.pixels) c.a = 255;
  }
  TextureAndLevels made{{options.format, size}, mip_levels(source, size, options.sampler)};
  made.texture.sampler = options.sampler;
  const IslandSize islands = options.islands ? *options.islands : islands_of(made.levels[0]);
  made.texture.size.levels = levels_with_islands(size, islands);
  made.texture.left_out = static_cast<std::uint8_t>(size.levels - made.texture.size.levels);
  made.levels.resize(made.texture.size.levels);
  if (options.format.layout == TexelLayout::kDirect) {
    store_colours(made.levels, options.dither, made.texture);
  } else if (options.format.layout == TexelLayout::kGray) {
    store_greys(made.levels, options.dither, made.texture);
  } else {
    store_indices(made.levels, options, made.texture, subject);
  }
  return made;
}

}  // namespace arcspan::tools
