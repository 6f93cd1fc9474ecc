// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_texture.hpp>

#include <cmath>

namespace arcspan::tools {

Uv GltfMapping::operator()(Uv point) const {
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  const double u = scale.u * point.u;
  const double v = scale.v * point.v;
  return {offset.u + c * u + s * v, offset.v - s * u + c * v};
}

GltfMapping read_gltf_mapping(const JsonView& info) {
  constexpr std::int64_t kMostSets = 15;
  GltfMapping mapping;
  mapping.set = info.integer_or("texCoord", 0, 0, kMostSets);
  const std::optional<JsonView> extensions = info.find("extensions");
  const std::optional<JsonView> transform =
      extensions ? extensions->find("KHR_texture_transform") : std::nullopt;
  if (!transform) return mapping;
  mapping.set = transform->integer_or("texCoord", mapping.set, 0, kMostSets);
  mapping.rotation = transform->number_or("rotation", 0);
  const auto pair = [&transform](const char* key, Uv value) {
    const std::optional<JsonView> member = transform->find(key);
    if (!member) return value;
    const std::vector<double> v = member->numbers(2, 2);
    return Uv{v[0], v[1]};
  };
  mapping.offset = pair("offset", {});
  mapping.scale = pair("scale", {1, 1});
  return mapping;
}

std::shared_ptr<const FileTexture> GltfTextures::read(GltfFile& file, const JsonView& id,
                                                      std::set<std::string>& not_drawn) {
  const JsonView texture = file.element("textures", id);
  const std::optional<JsonView> source = texture.find("source");
  if (!source) {
    not_drawn.insert("textures of other formats");
    return nullptr;
  }
  const JsonView image = file.element("images", *source);
  const auto [at, is_new] = known_.try_emplace(image.place());
  if (!is_new) return at->second;
  const std::optional<std::string> bytes = file.image_bytes(image);
  if (!bytes) {
    not_drawn.insert("textures that cannot be read from the model's folder");
    return nullptr;
  }
  const std::string name = image.text_or("name", image.place());
  at->second = std::make_shared<FileTexture>(
      FileTexture{name, decode_rgba(*bytes, file.subject() + ": " + image.place())});
  return at->second;
}

}  // namespace arcspan::tools
