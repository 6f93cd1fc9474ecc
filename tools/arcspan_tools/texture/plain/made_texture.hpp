// SPDX-License-Identifier: MIT
#pragma once

#include <arcspan/texture/texture_binary.hpp>

#include <arcspan_tools/image/rgba_image.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace arcspan::tools {

/// A texel format of the library as options name it.
struct TextureFormat {
  const char* name;
  TexelLayout layout;
  std::uint8_t alpha_bits;
};

/// rgb565, rgba5551, rgba4444; pal8 and pal4 with the colours of rgb565, or -5551, -4444; gray.
[[nodiscard]] std::span<const TextureFormat> texture_formats();

/// The format of that name.
[[nodiscard]] std::optional<TextureFormat> find_texture_format(std::string_view name);

/// The C++ type of the format: `arcspan::Palette8Texels<>`.
[[nodiscard]] std::string type_of(const TextureFormat& format);

/// A texture as the library takes it. `texels` has a number for each texel of all levels: its colour as the
/// format stores it, an index of `palette`, or a grey level.
struct MadeTexture {
  TextureFormat format;
  TextureSize size;
  std::uint8_t left_out = 0;  ///< levels that are not made, because islands would have less than two texels
  std::vector<std::uint16_t> palette{};  ///< as many colours as the format has
  std::vector<std::uint16_t> texels{};
  TextureSampler sampler{};

  /// The bytes that a firmware stores.
  [[nodiscard]] std::size_t bytes() const {
    return 2 * palette.size() + texture_binary::texel_bytes(format.layout, size);
  }
};

/// A line for reports if levels are left out, otherwise an empty string.
[[nodiscard]] std::string left_out_text(const MadeTexture& texture);

/// `colour` as a format with `alpha_bits` stores it in 16 bits: the nearest one.
[[nodiscard]] std::uint16_t stored_colour(Rgba8 colour, unsigned alpha_bits);

/// The colour that the library draws for a stored one, as display values.
[[nodiscard]] Rgba8 drawn_colour(std::uint16_t stored, unsigned alpha_bits);

/// A level of a texture as the library draws it.
[[nodiscard]] RgbaImage drawn_level(const MadeTexture& texture, unsigned level);

}  // namespace arcspan::tools
