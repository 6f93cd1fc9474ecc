// SPDX-License-Identifier: MIT
#include <arcspan_tools/output/array_text.hpp>
#include <arcspan_tools/output/bytes.hpp>
#include <arcspan_tools/output/texture_writer.hpp>

namespace arcspan::tools {
namespace {

/// The words of the texels as the library reads them; two texels of 4 bits share one.
std::vector<std::uint16_t> words_of(const MadeTexture& texture) {
  if (texture.format.layout != TexelLayout::kPalette4) return texture.texels;
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i < texture.texels.size(); i += 2) {
    const unsigned right = i + 1 < texture.texels.size() ? texture.texels[i + 1] : 0u;
    words.push_back(static_cast<std::uint16_t>((static_cast<unsigned>(texture.texels[i]) << 4u) | right));
  }
  return words;
}

ArrayText texts_of(const std::vector<std::uint16_t>& values) {
  ArrayText text;
  for (const std::uint16_t value : values) text.add(std::to_string(value));
  return text;
}

const char* wrap_text(TextureWrap wrap) {
  if (wrap == TextureWrap::kRepeat) return "arcspan::TextureWrap::kRepeat";
  return wrap == TextureWrap::kClamp ? "arcspan::TextureWrap::kClamp" : "arcspan::TextureWrap::kMirror";
}

/// The call that gives a texture its sampler, unless it is the default.
std::string sampler_text(const TextureSampler& sampler) {
  if (sampler == TextureSampler{}) return {};
  const bool bilinear = sampler.filter == TextureFilter::kBilinear;
  return std::string("\n        .with({") + wrap_text(sampler.u) + ", " + wrap_text(sampler.v) +
         (bilinear ? ",\n               arcspan::TextureFilter::kBilinear})" : "})");
}

std::string side(unsigned bits) { return std::to_string(1u << bits); }

/// A texture binary, of which `checksum` bytes are still to be appended.
std::string texture_before_checksum(const MadeTexture& texture, std::size_t checksum) {
  const TextureSize& size = texture.size;
  const TexelLayout layout = texture.format.layout;
  const std::size_t bytes = texture_binary::bytes(layout, size) - texture_binary::kChecksumBytes;
  std::string out;
  append_number(out, texture_binary::kMagic, 4);
  append_number(out, texture_binary::kVersion, 2);
  append_number(out, static_cast<std::uint8_t>(layout), 1);
  append_number(out, texture.format.alpha_bits, 1);
  append_number(out, bytes + checksum, 4);
  for (const std::uint8_t value :
       {size.width_bits, size.height_bits, size.levels, texture_binary::sampler_byte(texture.sampler)}) {
    append_number(out, value, 1);
  }
  for (const std::uint16_t colour : texture.palette) append_number(out, colour, 2);
  for (const std::uint16_t word : words_of(texture)) {
    append_number(out, word, layout == TexelLayout::kDirect ? 2 : 1);
  }
  out.resize(bytes, '\0');
  return out;
}

}  // namespace

std::string texture_arrays(const MadeTexture& texture) {
  const TextureSize& size = texture.size;
  const bool direct = texture.format.layout == TexelLayout::kDirect;
  const bool palette = !texture.palette.empty();
  std::string text;
  if (palette) text += texts_of(texture.palette).array("std::uint16_t", "kPalette");
  text += texts_of(words_of(texture)).array(direct ? "std::uint16_t" : "std::uint8_t", "kTexels");
  return text + "inline constexpr arcspan::Texture<" + type_of(texture.format) +
         "> kTexture =\n    arcspan::Texture<" + type_of(texture.format) + ">::of(kTexels, {" +
         std::to_string(size.width_bits) + ", " + std::to_string(size.height_bits) + ", " +
         std::to_string(size.levels) + "}" + (palette ? ", kPalette" : "") + ")" +
         sampler_text(texture.sampler) + ";\n\n";
}

std::string texture_header(const MadeTexture& texture, const std::string& name, const std::string& origin) {
  const TextureSize& size = texture.size;
  return "// Made by `arcspan texture` from " + harmless(origin) + ".\n//\n// " + side(size.width_bits) +
         "x" + side(size.height_bits) + " texels, " + texture.format.name +
         ", levels: " + std::to_string(size.levels) + ", " + std::to_string(texture.bytes()) +
         " bytes.\n#pragma once\n\n#include <arcspan/texture/texture.hpp>\n\n#include "
         "<cstdint>\n\nnamespace " +
         name + " {\n\n" + texture_arrays(texture) + "}  // namespace " + name + "\n";
}

std::string texture_chunk(const MadeTexture& texture) { return texture_before_checksum(texture, 0); }

std::string texture_binary_file(const MadeTexture& texture) {
  std::string out = texture_before_checksum(texture, texture_binary::kChecksumBytes);
  append_checksum(out);
  return out;
}

}  // namespace arcspan::tools
