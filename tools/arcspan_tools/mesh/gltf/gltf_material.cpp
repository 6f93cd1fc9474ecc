// SPDX-License-Identifier: MIT
#include <arcspan_tools/mesh/gltf/gltf_material.hpp>
#include <arcspan_tools/support/srgb.hpp>

#include <algorithm>
#include <cmath>

namespace arcspan::tools {
namespace {

constexpr const char* kOtherTextures = "textures other than the base colour's";
constexpr double kAboveAllAlpha = 2;  ///< a cutoff that no texel reaches
constexpr double kDielectric = 0.04;  ///< reflectance of a surface that is no metal, seen from the front

/// Red, green and blue of a member of three or four numbers, each 0...1.
Vec3 colour_or(const JsonView& json, const std::string& key, Vec3 value) {
  const std::optional<JsonView> member = json.find(key);
  if (!member) return value;
  const std::vector<double> v = member->numbers(3, 4);
  const auto channel = [&v](std::size_t i) { return std::clamp(v[i], 0.0, 1.0); };
  return {channel(0), channel(1), channel(2)};
}

double factor_or(const JsonView& json, const std::string& key, double value) {
  return std::clamp(json.number_or(key, value), 0.0, 1.0);
}

/// The highlight of a lobe of this width whose reflectance is `front`.
void set_highlight(FileMaterial& material, Vec3 front, double roughness) {
  constexpr double kMost = 256;
  const double alpha = std::max(roughness * roughness, 1e-3);
  const double exponent = std::clamp(2 / (alpha * alpha) - 2, 1.0, kMost);
  material.shininess = static_cast<std::int32_t>(std::lround(exponent));
  material.specular = to_srgb(front * ((exponent + 2) / 8));
}

/// The extension of specular colour and glossiness, which older files have.
GltfMaterial from_glossiness(const JsonView& json) {
  GltfMaterial result;
  result.base = colour_or(json, "diffuseFactor", {1, 1, 1});
  result.material.colour = to_srgb(result.base);
  set_highlight(result.material, colour_or(json, "specularFactor", {1, 1, 1}),
                1 - factor_or(json, "glossinessFactor", 1));
  return result;
}

/// If `unlit`, only the base colour counts: the other factors are for viewers that cannot draw unlit
/// materials.
GltfMaterial from_metallic_roughness(const JsonView& material, bool unlit) {
  const std::optional<JsonView> json = material.find("pbrMetallicRoughness");
  const Vec3 base = json ? colour_or(*json, "baseColorFactor", {1, 1, 1}) : Vec3{1, 1, 1};
  const auto factor = [&json](const char* key) { return json ? factor_or(*json, key, 1) : 1; };
  return phong_of(base, unlit ? 0 : factor("metallicFactor"), factor("roughnessFactor"));
}

/// Materials of 1.0 are Phong's already; their colours are display values.
GltfMaterial from_version_1(GltfFile& file, const JsonView& json, GltfTextures& textures, LeftOut& left_out) {
  GltfMaterial result;
  result.material.colour = Vec3{1, 1, 1};
  const std::optional<JsonView> values = json.find("values");
  if (!values) return result;
  const auto colour = [&](const char* key) -> std::optional<Vec3> {
    const std::optional<JsonView> member = values->find(key);
    if (!member) return std::nullopt;
    if (!member->is_text()) return colour_or(*values, key, {});
    if (std::string(key) == "diffuse") {
      textures.read(file, *member, left_out, result.material);
    } else {
      left_out.add(kOtherTextures);
    }
    return std::nullopt;
  };
  result.material.colour = colour("diffuse").value_or(Vec3{1, 1, 1});
  result.material.specular = colour("specular").value_or(Vec3{});
  const double shininess = std::clamp(values->number_or("shininess", 1), 1.0, 256.0);
  result.material.shininess = static_cast<std::int32_t>(std::lround(shininess));
  return result;
}

bool has_other_texture(const JsonView& json) {
  for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
    if (json.find(key)) return true;
  }
  const std::optional<JsonView> metallic = json.find("pbrMetallicRoughness");
  return metallic && metallic->find("metallicRoughnessTexture");
}

/// Reads the texture that multiplies the colour: `key` of `json`, a set of factors.
void read_texture(GltfFile& file, const std::optional<JsonView>& json, const char* key,
                  GltfTextures& textures, LeftOut& left_out, GltfMaterial& result) {
  const std::optional<JsonView> info = json ? json->find(key) : std::nullopt;
  if (!info) return;
  textures.read(file, info->at("index"), left_out, result.material);
  result.mapping = read_gltf_mapping(*info);
}

/// The fourth number of a colour, 1 if there is none.
double alpha_or_one(const std::optional<JsonView>& json, const char* key) {
  const std::optional<JsonView> member = json ? json->find(key) : std::nullopt;
  if (!member) return 1;
  const std::vector<double> v = member->numbers(3, 4);
  return v.size() < 4 ? 1 : std::clamp(v[3], 0.0, 1.0);
}

/// `factor`: the alpha of the base colour, by which that of the texture is multiplied.
void read_alpha(const JsonView& json, double factor, FileMaterial& material, LeftOut& left_out) {
  const std::string mode = json.text_or("alphaMode", "OPAQUE");
  if (mode == "OPAQUE") return;
  if (mode != "MASK" && mode != "BLEND") return left_out.add("unknown alpha modes");
  material.alpha_mode = mode == "MASK" ? AlphaMode::kMask : AlphaMode::kBlend;
  if (mode != "MASK") {
    material.opacity = factor;
    return;
  }
  // Above 1 nothing is drawn, says the specification.
  material.alpha_cutoff = std::max(json.number_or("alphaCutoff", 0.5), 0.0);
  if (material.texture == nullptr) {
    material.opacity = factor < material.alpha_cutoff ? 0 : 1;
  } else if (factor > 0) {
    material.alpha_cutoff /= factor;
  } else if (material.alpha_cutoff > 0) {
    material.alpha_cutoff = kAboveAllAlpha;
  }
}

void note_what_is_left_out(const JsonView& json, LeftOut& left_out) {
  if (has_other_texture(json)) left_out.add(kOtherTextures);
  const std::optional<JsonView> extensions = json.find("extensions");
  if (!extensions) return;
  for (const std::string& name : extensions->keys()) {
    if (name != "KHR_materials_unlit" && name != "KHR_materials_pbrSpecularGlossiness") left_out.add(name);
  }
}

}  // namespace

GltfMaterial phong_of(Vec3 base, double metallic, double roughness) {
  GltfMaterial result;
  result.base = base * (1 - metallic / 2);
  result.material.colour = to_srgb(result.base);
  const double dielectric = kDielectric * (1 - metallic);
  set_highlight(result.material, Vec3{dielectric, dielectric, dielectric} + base * metallic, roughness);
  return result;
}

GltfMaterial read_gltf_material(GltfFile& file, const JsonView& json, GltfTextures& textures,
                                LeftOut& left_out) {
  const std::string name = json.text_or("name", "");
  if (file.version() == 1) {
    GltfMaterial result = from_version_1(file, json, textures, left_out);
    result.material.name = name;
    return result;
  }
  const std::optional<JsonView> extensions = json.find("extensions");
  const std::optional<JsonView> glossiness =
      extensions ? extensions->find("KHR_materials_pbrSpecularGlossiness") : std::nullopt;
  const bool unlit = extensions && extensions->find("KHR_materials_unlit");
  GltfMaterial result = glossiness ? from_glossiness(*glossiness) : from_metallic_roughness(json, unlit);
  if (glossiness) {
    read_texture(file, glossiness, "diffuseTexture", textures, left_out, result);
    if (glossiness->find("specularGlossinessTexture")) left_out.add(kOtherTextures);
  } else {
    read_texture(file, json.find("pbrMetallicRoughness"), "baseColorTexture", textures, left_out, result);
  }
  read_alpha(json,
             glossiness ? alpha_or_one(glossiness, "diffuseFactor")
                        : alpha_or_one(json.find("pbrMetallicRoughness"), "baseColorFactor"),
             result.material, left_out);
  result.material.name = name;
  if (!unlit) result.material.emission = to_srgb(colour_or(json, "emissiveFactor", {}));
  const std::optional<JsonView> two_sided = json.find("doubleSided");
  result.material.two_sided = two_sided && two_sided->truth();
  result.material.unlit = unlit;
  note_what_is_left_out(json, left_out);
  return result;
}

}  // namespace arcspan::tools
