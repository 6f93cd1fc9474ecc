// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/plain/made_texture.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace arcspan::tools {
namespace {

constexpr TextureFormat kFormats[] = {
    {"rgb565", TexelLayout::kDirect, 0},      {"rgba5551", TexelLayout::kDirect, 1},
    {"rgba4444", TexelLayout::kDirect, 4},    {"pal8", TexelLayout::kPalette8, 0},
    {"pal8-5551", TexelLayout::kPalette8, 1}, {"pal8-4444", TexelLayout::kPalette8, 4},
    {"pal4", TexelLayout::kPalette4, 0},      {"pal4-5551", TexelLayout::kPalette4, 1},
    {"pal4-4444", TexelLayout::kPalette4, 4}, {"gray", TexelLayout::kGray, 0},
};

/// A 5-6-5 pixel as display values; the highest bits are repeated below.
Rgba8 widened(std::uint16_t rgb565, std::uint32_t alpha16) {
  const unsigned r = rgb565 >> 11u;
  const unsigned g = (rgb565 >> 5u) & 63u;
  const unsigned b = rgb565 & 31u;
  return {static_cast<std::uint8_t>((r << 3u) | (r >> 2u)), static_cast<std::uint8_t>((g << 2u) | (g >> 4u)),
          static_cast<std::uint8_t>((b << 3u) | (b >> 2u)),
          static_cast<std::uint8_t>((alpha16 * 255u + 8u) / 16u)};
}

template <TexelColour C>
Rgba8 drawn(std::uint16_t stored) {
  return widened(C::rgb565(stored), C::alpha(stored));
}

/// The bits of an opaque texel's alpha.
template <TexelColour C>
constexpr std::uint16_t opaque_bits() {
  return static_cast<std::uint16_t>(((1u << C::kAlphaBits) - 1) << C::kAlphaShift);
}

/// For each of 256 levels, the stored channel at bit `shift` that is drawn nearest to it.
template <TexelColour C>
std::array<std::uint16_t, 256> nearest_levels(unsigned shift, unsigned bits, std::uint8_t Rgba8::*channel) {
  std::array<std::uint16_t, 256> table{};
  for (int level = 0; level < 256; ++level) {
    int least = 256;
    for (unsigned value = 0; value < 1u << bits; ++value) {
      const auto stored = static_cast<std::uint16_t>(value << shift);
      // Colours of opaque texels; their alpha is not a part of what is stored.
      const auto shown =
          static_cast<std::uint16_t>(channel == &Rgba8::a ? stored : stored | opaque_bits<C>());
      const int error = std::abs(drawn<C>(shown).*channel - level);
      if (error >= least) continue;
      least = error;
      table[static_cast<std::size_t>(level)] = stored;
    }
  }
  return table;
}

/// The stored colour that is drawn nearest to `c`. Red, green and blue begin at these bits.
template <TexelColour C, unsigned red, unsigned green, unsigned blue>
std::uint16_t nearest(Rgba8 c) {
  constexpr unsigned kBits = C::kAlphaBits == 4 ? 4 : 5;
  static const auto kReds = nearest_levels<C>(red, kBits, &Rgba8::r);
  static const auto kGreens = nearest_levels<C>(green, C::kAlphaBits == 0 ? 6 : kBits, &Rgba8::g);
  static const auto kBlues = nearest_levels<C>(blue, kBits, &Rgba8::b);
  static const auto kAlphas = nearest_levels<C>(C::kAlphaShift, C::kAlphaBits, &Rgba8::a);
  return static_cast<std::uint16_t>(kReds[c.r] | kGreens[c.g] | kBlues[c.b] | kAlphas[c.a]);
}

}  // namespace

std::span<const TextureFormat> texture_formats() { return kFormats; }

std::optional<TextureFormat> find_texture_format(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                         [name](const TextureFormat& f) { return f.name == name; });
  return found == std::end(kFormats) ? std::nullopt : std::optional(*found);
}

std::string type_of(const TextureFormat& format) {
  if (format.layout == TexelLayout::kGray) return "arcspan::GrayTexels";
  const char* const layout = format.layout == TexelLayout::kDirect     ? "DirectTexels"
                             : format.layout == TexelLayout::kPalette8 ? "Palette8Texels"
                                                                       : "Palette4Texels";
  const char* const colour = format.alpha_bits == 0   ? ""
                             : format.alpha_bits == 1 ? "arcspan::Alpha1Colour"
                                                      : "arcspan::Alpha4Colour";
  return std::string("arcspan::") + layout + "<" + colour + ">";
}

std::string left_out_text(const MadeTexture& texture) {
  if (texture.left_out == 0) return {};
  return std::to_string(texture.left_out) + (texture.left_out == 1 ? " level is" : " levels are") +
         " left out, in which islands would have less than two texels\n";
}

std::uint16_t stored_colour(Rgba8 c, unsigned alpha_bits) {
  if (alpha_bits == 0) return nearest<OpaqueColour, 11, 5, 0>(c);
  return alpha_bits == 1 ? nearest<Alpha1Colour, 11, 6, 0>(c) : nearest<Alpha4Colour, 12, 8, 4>(c);
}

Rgba8 drawn_colour(std::uint16_t stored, unsigned alpha_bits) {
  if (alpha_bits == 0) return drawn<OpaqueColour>(stored);
  return alpha_bits == 1 ? drawn<Alpha1Colour>(stored) : drawn<Alpha4Colour>(stored);
}

RgbaImage drawn_level(const MadeTexture& texture, unsigned level) {
  const TextureSize& size = texture.size;
  RgbaImage image(1 << (size.width_bits - level), 1 << (size.height_bits - level));
  const std::uint16_t* const texels = texture.texels.data() + size.texels(level);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const auto grey = static_cast<std::uint8_t>(texels[i]);
    const std::uint16_t stored = texture.format.layout == TexelLayout::kGray
                                     ? GrayTexels::stored(&grey, nullptr, 0)
                                 : texture.palette.empty() ? texels[i]
                                                           : texture.palette[texels[i]];
    image.pixels[i] = drawn_colour(stored, texture.format.alpha_bits);
  }
  return image;
}

}  // namespace arcspan::tools
