// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_texture.hpp>

#include <cmath>
#include <utility>

namespace arcspan::tools {
namespace {

/// Adds what differs from a texture that repeats and whose nearest texel is drawn.
void note_sampler(const JsonView& sampler, LeftOut& left_out) {
  constexpr std::int64_t kMostNumber = 0xFFFF;
  constexpr std::int64_t kRepeat = 10497;
  constexpr std::int64_t kClamp = 33071;
  constexpr std::int64_t kNearest = 9728;  // the numbers of linear filters are odd
  for (const char* direction : {"wrapS", "wrapT"}) {
    const std::int64_t mode = sampler.integer_or(direction, kRepeat, 0, kMostNumber);
    if (mode == kRepeat) continue;
    left_out.add(mode == kClamp ? "clamped edges of textures, which repeat"
                                : "mirrored textures, which repeat");
    break;
  }
  for (const char* filter : {"magFilter", "minFilter"}) {
    if (sampler.integer_or(filter, kNearest, 0, kMostNumber) % 2 == 0) continue;
    left_out.add("linear filters of textures");
    break;
  }
}

}  // namespace

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

std::shared_ptr<const FileTexture> GltfTextures::read(GltfFile& file, const JsonView& id, LeftOut& left_out) {
  const JsonView texture = file.element("textures", id);
  const bool is_new = known_.insert(texture.place()).second;
  if (const std::optional<JsonView> sampler = texture.find("sampler"); sampler && is_new) {
    note_sampler(file.element("samplers", *sampler), left_out);
  }
  const std::optional<JsonView> source = texture.find("source");
  if (!source) {
    if (is_new) left_out.add("textures of other formats");
    return nullptr;
  }
  const JsonView image = file.element("images", *source);
  const std::optional<JsonView> uri = image.find("uri");
  const std::string name =
      uri && uri->is_text() && !uri->text().starts_with("data:") ? uri->text() : image.place();
  return pictures_.picture(name, [&]() -> std::optional<ReferredFile> {
    std::optional<std::string> bytes = file.image_bytes(image);
    if (!bytes) return std::nullopt;
    return ReferredFile{file.subject() + ": " + name, std::move(*bytes)};
  });
}

}  // namespace arcspan::tools
