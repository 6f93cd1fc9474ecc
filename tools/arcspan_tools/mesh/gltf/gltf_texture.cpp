// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_texture.hpp>

#include <cmath>
#include <utility>

namespace arcspan::tools {
namespace {

TextureWrap wrap_of(const JsonView& sampler, const char* axis, LeftOut& left_out) {
  constexpr std::int64_t kRepeat = 10497;
  constexpr std::int64_t kClamp = 33071;
  constexpr std::int64_t kMirror = 33648;
  const std::int64_t mode = sampler.integer_or(axis, kRepeat, 0, 0xFFFF);
  if (mode == kClamp) return TextureWrap::kClamp;
  if (mode == kMirror) return TextureWrap::kMirror;
  if (mode != kRepeat) left_out.add("unknown wrapping of textures, which repeat");
  return TextureWrap::kRepeat;
}

/// magFilter, or minFilter if that is all that the file states. What minFilter says of mip levels is not
/// drawn: a triangle, or a piece of a row in perspective, has one level.
TextureFilter filter_of(const JsonView& sampler, LeftOut& left_out) {
  constexpr std::int64_t kNearest = 9728;  // the numbers of linear filters are odd
  const std::int64_t small = sampler.integer_or("minFilter", kNearest, 0, 0xFFFF);
  const std::int64_t large = sampler.integer_or("magFilter", small, 0, 0xFFFF);
  if (sampler.find("minFilter") && (small - large) % 2 != 0)
    left_out.add("filters of textures that differ far away");
  return large % 2 == 0 ? TextureFilter::kNearest : TextureFilter::kBilinear;
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

void GltfTextures::read(GltfFile& file, const JsonView& id, LeftOut& left_out, FileMaterial& material) {
  const JsonView texture = file.element("textures", id);
  LeftOut known;  // of a texture that was read before
  LeftOut& new_left_out = known_.insert(texture.place()).second ? left_out : known;
  const std::optional<JsonView> source = texture.find("source");
  if (!source) {
    new_left_out.add("textures of other formats");
    return;
  }
  if (const std::optional<JsonView> name = texture.find("sampler")) {
    const JsonView sampler = file.element("samplers", *name);
    material.sampler = {wrap_of(sampler, "wrapS", new_left_out), wrap_of(sampler, "wrapT", new_left_out),
                        filter_of(sampler, new_left_out)};
  }
  material.texture = picture(file, *source);
}

std::shared_ptr<const FileTexture> GltfTextures::picture(GltfFile& file, const JsonView& source) {
  const JsonView image = file.element("images", source);
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
