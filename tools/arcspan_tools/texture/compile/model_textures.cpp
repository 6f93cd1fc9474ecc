// SPDX-License-Identifier: MIT
#include <arcspan_tools/texture/compile/model_textures.hpp>
#include <arcspan_tools/texture/plain/surface_texture.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace arcspan::tools {
namespace {

/// The bits of alpha that a material needs.
std::uint8_t alpha_bits_of(const FileMaterial& material) {
  if (material.texture == nullptr || material.alpha_mode == AlphaMode::kOpaque) return 0;
  return material.alpha_mode == AlphaMode::kMask ? 1 : 4;
}

/// The format with this layout and at least as many bits of alpha as all materials need, if there is one.
TextureFormat common_format(const FixedModel& model, const TextureFormat& wanted) {
  std::uint8_t bits = wanted.alpha_bits;
  for (const PartLook& look : model.looks) bits = std::max(bits, alpha_bits_of(look.material));
  for (const TextureFormat& format : texture_formats()) {
    if (format.layout == wanted.layout && format.alpha_bits == bits) return format;
  }
  return wanted;
}

}  // namespace

std::size_t ModelTextures::bytes() const {
  std::size_t sum = 0;
  for (const MadeTexture& texture : textures) sum += texture.bytes();
  return sum;
}

ModelTextures make_textures(const FixedModel& model, const TextureOptions& options) {
  using Key = std::tuple<const FileTexture*, AlphaMode, double, std::uint8_t>;
  ModelTextures made;
  TextureOptions own = options;
  own.format = common_format(model, options.format);
  std::map<Key, std::size_t> known;
  for (const PartLook& look : model.looks) {
    const FileMaterial& material = look.material;
    if (material.texture == nullptr) {
      made.of_part.emplace_back();
      continue;
    }
    const Key key{material.texture.get(), material.alpha_mode, material.alpha_cutoff,
                  texture_binary::sampler_byte(material.sampler)};
    const auto [at, is_new] = known.try_emplace(key, made.textures.size());
    if (is_new) {
      own.sampler = material.sampler;
      own.islands = islands_of(model, *material.texture);
      made.textures.push_back(make_texture(picture_of(material), own, material.texture->name).texture);
    }
    made.of_part.emplace_back(at->second);
  }
  if (made.textures.empty()) made.of_part.clear();
  return made;
}

FixedModel with_made_textures(FixedModel model, const ModelTextures& made) {
  for (std::size_t i = 0; i < made.of_part.size(); ++i) {
    if (!made.of_part[i]) continue;
    const MadeTexture& texture = made.textures[*made.of_part[i]];
    FileMaterial& material = model.looks[i].material;
    std::vector<RgbaImage> smaller;
    for (unsigned level = 1; level < texture.size.levels; ++level)
      smaller.push_back(drawn_level(texture, level));
    material.texture = std::make_shared<FileTexture>(
        FileTexture{material.texture->name, drawn_level(texture, 0), std::move(smaller)});
  }
  return model;
}

}  // namespace arcspan::tools
